// Which structural models and coupling schemes suit a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupler/advise/scene_numbers.hpp"

namespace cosurge {

/// The verdict on one model or scheme.
struct Fit {
  std::string name;  ///< word of the case
  bool fits = false;
  std::string why = {};  ///< the number and its limit
};

/// Largest mu at which `weak` is stable with these settings (docs/stability.md, what to choose); nothing for
/// a combination that is not in the table there.
std::optional<double> weak_limit(const v1::Coupling& coupling);

/// Every model of `solid.model`. Limits: for `rigid` a static deflection of 1 % of a spacing and a period as
/// long as the water's response; for `modal` a deflection of 5 % of the longest side (docs/method_solid.md,
/// section 6); for `mps` and `hamiltonian` 4 particles across.
std::vector<Fit> model_fits(const v1::Case& the_case, const SceneNumbers& scene);

/// Every scheme of `coupling.scheme`, with the case's model and settings (docs/stability.md).
std::vector<Fit> scheme_fits(const v1::Case& the_case, const SceneNumbers& scene);

/// One sentence with the model and the scheme to use.
std::string recommendation(const v1::Case& the_case, const SceneNumbers& scene);

/// Spacings that are too coarse: fewer than 4 points across a body, fewer than 10 layers of water
/// (docs/speed_accuracy.md, cosurge advise).
std::vector<std::string> coarse_spacings(const v1::Case& the_case, const SceneNumbers& scene);

}  // namespace cosurge
