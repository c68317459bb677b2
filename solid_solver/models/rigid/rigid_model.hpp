// The model `rigid`: all bodies are held.
#pragma once

#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge {

/// The nodes of each body are held: one in the middle of the box around it, and one at a distance from there
/// along each axis, so that the motion of a carrier is affine between them. The reported load is the total
/// load, which the supports balance.
template <int dim>
class RigidModel : public SolidModel {
 public:
  explicit RigidModel(const Structure<dim>& structure);

  Eigen::Index nodes() const override { return bodies() * per_body; }
  std::uint64_t particles() const override { return positions_.size() / dim; }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return 0; }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return Field::Zero(dim, nodes()); }
  Field velocity() const override { return Field::Zero(dim, nodes()); }
  Field ramp_increment() const override { return Field::Zero(dim, nodes()); }
  Field acceleration_by(const Field& load) const override { return Field::Zero(dim, load.cols()); }
  NodeLayout layout() const override;
  Field inertia(const Field& acceleration) const override { return Field::Zero(dim, acceleration.cols()); }
  double max_speed() const override { return 0; }
  Energies energies() const override { return {}; }

  /// Total load on all bodies at the end of the window [N]; the supports answer with its opposite.
  std::vector<Column> columns() const override;
  std::vector<double> values() const override;

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  static constexpr int per_body = dim + 1;

  Eigen::Index bodies() const { return static_cast<Eigen::Index>(bounds_.size()); }
  Vec<dim> middle(std::size_t body) const { return 0.5 * (bounds_[body].min + bounds_[body].max); }
  double length(std::size_t body) const { return (bounds_[body].max - bounds_[body].min).maxCoeff(); }

  std::vector<Box<dim>> bounds_;  // box of each body
  std::vector<int> particle_body_;
  std::vector<float> positions_;  // lattice points in the bodies, for frames
  Eigen::VectorXd total_load_ = Eigen::VectorXd::Zero(dim);
};

}  // namespace cosurge
