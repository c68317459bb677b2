// The model `rigid`: bodies that stand still.
#pragma once

#include "solid_solver/solid_model.hpp"

namespace cosurge {

/// Each body is one node, held. Its load is what holds it: the reaction.
template <int dim>
class RigidModel : public SolidModel {
 public:
  explicit RigidModel(const v1::Solid& solid, double spacing);

  Eigen::Index nodes() const override { return bodies_; }
  std::uint64_t particles() const override { return positions_.size() / dim; }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return 0; }
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return Field::Zero(dim, bodies_); }
  Field velocity() const override { return Field::Zero(dim, bodies_); }
  Field ramp_increment() const override { return Field::Zero(dim, bodies_); }
  Field acceleration_by(const Field& load) const override { return Field::Zero(dim, load.cols()); }
  double max_speed() const override { return 0; }
  Energies energies() const override { return {}; }

  /// Total load on all bodies at the end of the window [N]; the supports answer with its opposite.
  std::vector<Column> columns() const override;
  std::vector<double> values() const override;

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  Eigen::Index bodies_;
  std::vector<float> positions_;  // of the lattice that fills the bodies, for frames
  Eigen::VectorXd total_load_ = Eigen::VectorXd::Zero(dim);
};

}  // namespace cosurge
