// A model far from the origin, computed near it.
#pragma once

#include <memory>

#include "common/error.hpp"
#include "solid_solver/structure.hpp"
#include "solid_solver/wrapped_model.hpp"

namespace cosurge {

/// Origin of the coordinates for bodies that are more than a hundred times as far from the scene's origin as
/// their size and would lose digits [m]; a multiple of the spacing. Nothing if the scene's origin serves.
template <int dim>
std::optional<Vec<dim>> origin_near_bodies(const Structure<dim>& structure);

/// The structure with bodies, clamps, supports and pivots relative to `origin`; the motions of carriers are
/// the same.
template <int dim>
Structure<dim> relocated(const Structure<dim>& structure, const Vec<dim>& origin);

/// Returns the result of `work`; messages of its errors state the origin of their coordinates.
template <typename Work>
auto saying_origin(const Eigen::VectorXd& origin, const Work& work) {
  const auto said = [&](const std::exception& error) {
    return fmt::format("{} (coordinates of the body are counted from ({:.10g}) m)", error.what(),
                       fmt::join(origin.begin(), origin.end(), ", "));
  };
  try {
    return work();
  } catch (const NumericalError& error) {
    throw NumericalError(said(error));
  } catch (const Error& error) {
    throw Error(said(error));
  }
}

/// Runs a model of the relocated structure on positions in the coordinates of the case.
class RelocatedModel : public WrappedModel {
 public:
  RelocatedModel(std::unique_ptr<SolidModel> model, const Eigen::VectorXd& origin);

  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  int advance(const Window& window, const NodalLoad& load) override;
  NodeLayout layout() const override;
  Snapshot frame() const override;

 private:
  Eigen::VectorXd origin_;
};

}  // namespace cosurge
