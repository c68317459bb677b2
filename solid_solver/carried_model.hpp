// A solid model with bodies on holders with prescribed motion.
#pragma once

#include <memory>

#include "solid_solver/structure.hpp"
#include "solid_solver/wrapped_model.hpp"

namespace cosurge {

/// Any model, computed in the frame of the carrier of each body: the tank, an obstacle, or a motion of the
/// body's own (docs/method_solid.md, section 13). Clamps, supports and springs are at rest in that frame, and
/// the nodes get the inertial forces of its motion. Displacements, velocities and energies are returned in
/// space.
template <int dim>
class CarriedModel : public WrappedModel {
 public:
  CarriedModel(std::unique_ptr<SolidModel> model, const Structure<dim>& structure);

  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override;
  Field velocity() const override;
  Field ramp_increment() const override { return ramp_increment_; }
  Field acceleration_by(const Field& load) const override;
  double max_speed() const override { return velocity().colwise().norm().maxCoeff(); }

  /// The kinetic energy includes clamped nodes, which move with the carrier.
  Energies energies() const override;
  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  const Motion<dim>& carrier(Eigen::Index node) const {
    return motion_[static_cast<std::size_t>(layout_.body[static_cast<std::size_t>(node)])];
  }
  std::vector<Mat<dim>> turned(double t) const;
  Field rotated(const Field& nodal, const std::vector<Mat<dim>>& rotation) const;
  Field carried(const Field& place, double t) const;
  Field carrier_velocities(const Field& place, double t) const;
  Field apparent_acceleration(const Field& place, const Window& window) const;

  NodeLayout layout_;
  std::vector<Motion<dim>> motion_;  // motion of each body's holder
  Vec<dim> gravity_ = Vec<dim>::Zero();
  double time_ = 0;  // end of the last window [s]
  Field ramp_increment_;
};

/// The model, wrapped if a holder of one of its bodies moves.
template <int dim>
std::unique_ptr<SolidModel> with_carriers(std::unique_ptr<SolidModel> model, const Structure<dim>& structure);

}  // namespace cosurge
