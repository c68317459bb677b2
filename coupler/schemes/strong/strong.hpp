// Coupling that is iterated within a window.
#pragma once

#include "coupler/scheme.hpp"
#include "coupler/schemes/prediction.hpp"
#include "coupler/schemes/strong/relaxation.hpp"

namespace cosurge {

/// Fluid and solid repeat the window, each time from its start, until the velocity of the solid agrees with
/// the velocity that the water used, and the corresponding change of the load is small, both to a relative
/// tolerance. In every iteration the water uses the positions of the bodies at the start of the window: so
/// the free surface and the matrix of the pressure do not change, and the load is a smooth function of the
/// velocity except for the cut-off of suction. If the iterations do not converge, the window is repeated once
/// with the velocity of the smallest residual, and the effort reports it. If nothing moves, one iteration is
/// enough.
///
/// `strong_inertial` also gives the water the structure's modes, as `weak_inertial` does: the water uses the
/// velocity x + R (f - f_0), with its own load f and the modes' mobility R, and x is iterated. The converged
/// solution does not depend on R; the iteration only has to find the response of the other modes.
class Strong : public Scheme {
 public:
  Strong(const v1::Coupling& coupling, Participants participants);

  Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) override;

  bool has_modes() const { return has_modes_; }  ///< whether the solid gives modes

  const Effort& effort() const override { return effort_; }
  const AddedMassRatio& ratio() const override { return ratio_; }
  void save(StateWriter& state) const override;
  void restore(InterfaceReader& state) override;

 private:
  /// One pass of fluid and solid through the window.
  struct Pass {
    Field asked;   // velocity given to the water
    Field seen;    // velocity that the water used, with the modes' response to its own load
    Field answer;  // velocity of the structure
    Field force;
    double residual() const { return (answer - seen).norm(); }
  };
  Reports pass(const Window& window, const InterfaceState& start, const Field& velocity,
               InterfaceState& interface);
  void learn(const Pass& now, const Pass& last);

  double tolerance_;
  int iterations_;
  Participants participants_;
  bool inertial_;
  std::vector<Mode> modes_;  // modes of the structure in this window; empty without inertial_
  Prediction prediction_;
  std::unique_ptr<Relaxation> relaxation_;
  bool has_modes_ = false;
  Effort effort_;
  AddedMassRatio ratio_;
  double stiffness_ = -1;  // kappa = |df| / |dv| [N s/m], the largest between iterations of the last window
                           // (docs/method.md, eq. 18b); -1: unknown
};

}  // namespace cosurge
