// The model `modal`: the lowest modes of the finite-element bodies.
#pragma once

#include "solid_solver/models/fem/generalised_alpha.hpp"
#include "solid_solver/models/fem/meshed_bodies.hpp"
#include "solid_solver/models/modal/modes.hpp"
#include "solid_solver/oscillator.hpp"

namespace cosurge::modal {

/// u = sum phi_i eta_i about the undeformed bodies, each mode advanced exactly over the window with
/// `solid.damping_ratio` (docs/method_solid.md, section 6). Oscillations that the window does not resolve
/// lose amplitude as in `fem`. Valid for small deflection only: deflection, rotation and strain are reported,
/// and `cosurge run` warns if they are too large.
template <int dim>
class ModalModel : public SolidModel {
 public:
  ModalModel(const Structure<dim>& structure, const ModalParameters& parameters);

  /// Modes of body b.
  const Modes& modes(std::size_t b) const { return modes_.at(b); }

  Eigen::Index nodes() const override { return bodies_.nodes(); }
  std::uint64_t particles() const override { return bodies_.particles(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override {
    return bodies_.interpolation(position, body);
  }
  double substep() const override { return 0; }

  /// One step, the window, under the linear load itself.
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return bodies_.to_nodes(displacements()); }
  Field velocity() const override { return bodies_.to_nodes(velocities()); }
  Field ramp_increment() const override { return bodies_.to_nodes(motion(&OscillatorState::ramp_increment)); }
  Field acceleration_by(const Field& load) const override;
  NodeLayout layout() const override { return bodies_.layout(); }
  Field inertia(const Field& acceleration) const override { return bodies_.inertia(acceleration); }
  double max_speed() const override { return bodies_.max_speed(velocities()); }
  Energies energies() const override;

  std::vector<NodalMode> modes(int count) const override;

  /// Measures of the assumption of small deflection: rotation, strain, and deflection over the body's longest
  /// side.
  std::vector<Column> columns() const override {
    return {{"largest_rotation", "rad"}, {"largest_strain", "-"}, {"largest_deflection", "-"}};
  }
  std::vector<double> values() const override;

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override { return bodies_.frame(displacements(), velocities()); }

  using Vectors = typename fem::MeshedBodies<dim>::Vectors;

  const fem::MeshedBodies<dim>& bodies() const { return bodies_; }

  // The motion over the unknowns of the bodies, in [m] and [m/s].
  Vectors displacements() const { return motion(&OscillatorState::position); }
  Vectors velocities() const { return motion(&OscillatorState::velocity); }
  /// The part of a motion that the modes represent.
  void place(const Vectors& displacements, const Vectors& velocities);

  /// Whether a body can move as a whole.
  bool has_free_motion() const;

  /// Static displacement of body b under constant forces on its unknowns [m], without free motion.
  fem::Vector deflection(std::size_t b, const fem::Vector& force) const;

 private:
  void prepare_steps(double h);
  double largest_deflection() const;

  /// One component of the modes' states, on the unknowns of the bodies.
  Vectors motion(double OscillatorState::*part) const;

  fem::MeshedBodies<dim> bodies_;
  std::vector<double> damping_;  // rate of each body [1/s]
  fem::AlphaConstants alpha_;    // constants of the numerical damping of fast oscillations
  std::vector<Modes> modes_;
  Vectors weight_;                                    // gravity's load on the modes
  std::vector<std::vector<OscillatorState>> states_;  // states of each body's modes
  std::vector<OscillatorStep> steps_;  // steps of all modes for a window of the size steps_size_
  double steps_size_ = 0;
};

}  // namespace cosurge::modal
