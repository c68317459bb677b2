// The model `fem`: finite elements of second order, implicit in time.
#pragma once

#include <deque>

#include "solid_solver/models/fem/generalised_alpha.hpp"
#include "solid_solver/models/fem/meshed_bodies.hpp"

namespace cosurge::fem {

/// Finite elements for large deformation (docs/method_solid.md, section 5). There is no stability limit of
/// the step: it is the window, or solid.fem.substep.
template <int dim>
class FemModel : public SolidModel {
 public:
  FemModel(const Structure<dim>& structure, const FemParameters& parameters);
  FemModel(const FemModel&) = delete;
  FemModel& operator=(const FemModel&) = delete;

  Eigen::Index nodes() const override { return bodies_.nodes(); }
  std::uint64_t particles() const override { return bodies_.particles(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override {
    return bodies_.interpolation(position, body);
  }
  double substep() const override { return substep_; }

  /// The load of sub-step k of n is taken at (k + 1 - alpha_f) / n of the window, the instant of the balance
  /// of forces (S25).
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return bodies_.to_nodes(displacements()); }
  Field velocity() const override { return bodies_.to_nodes(velocities()); }
  Field ramp_increment() const override { return bodies_.to_nodes(ramp_increment_); }
  Field acceleration_by(const Field& load) const override { return bodies_.acceleration_by(load); }
  NodeLayout layout() const override { return bodies_.layout(); }
  Field inertia(const Field& acceleration) const override { return bodies_.inertia(acceleration); }
  double max_speed() const override { return bodies_.max_speed(velocities()); }
  Energies energies() const override;

  /// Newton iterations of the window, over all sub-steps and bodies.
  std::vector<Column> columns() const override { return {{"newton_iterations", "-"}}; }
  std::vector<double> values() const override { return {static_cast<double>(iterations_)}; }

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override { return bodies_.frame(displacements(), velocities()); }

  using Vectors = typename MeshedBodies<dim>::Vectors;

  // The motion over the unknowns of the bodies, in [m] and [m/s].
  Vectors displacements() const;
  Vectors velocities() const;
  void place(const Vectors& displacements, const Vectors& velocities);

 private:
  void check_step(const NewtonReport& report, const Window& window, std::size_t body, double dt) const;

  MeshedBodies<dim> bodies_;
  std::deque<GeneralisedAlpha<dim>> motions_;  // one per body; a deque, since they cannot be moved
  double substep_;                             // [s]; 0: the window
  Vectors ramp_increment_;
  int iterations_ = 0;
};

}  // namespace cosurge::fem
