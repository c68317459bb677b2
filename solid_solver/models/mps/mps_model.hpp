// The model `mps`: bodies of explicit MPS particles.
#pragma once

#include "solid_solver/models/mps/mps_body.hpp"
#include "solid_solver/solid_model.hpp"

namespace cosurge::mps {

/// Nodes are the particles, held ones included, body after body.
template <int dim>
class MpsModel : public SolidModel {
 public:
  /// @param spacing l0 [m]
  /// @throws Error for a body without free particles or thinner than two, and for a sub-step beyond the
  /// stable one.
  MpsModel(const v1::Solid& solid, double spacing, const Vec<dim>& gravity);

  /// The longest stable step [s] (docs/method_solid.md, S12).
  double stable_step() const { return stable_step_; }

  Eigen::Index nodes() const override { return first_.back(); }
  std::uint64_t particles() const override { return static_cast<std::uint64_t>(nodes()); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return substep_; }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override;
  Field ramp_increment() const override;
  double max_speed() const override;
  Energies energies() const override;
  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  using Row = std::vector<std::pair<std::size_t, double>>;

  Row interpolation_row(const BodyGrid<dim>& grid, const Vec<dim>& x) const;
  void check_motion(const Window& window) const;

  Elasticity material_;
  double spacing_;
  double stable_step_;
  double substep_;
  double last_dt_ = 0;
  std::vector<MpsBody<dim>> bodies_;
  std::vector<Eigen::Index> first_;  // node of each body, and their number
};

}  // namespace cosurge::mps
