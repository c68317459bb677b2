// The model `sprung`: rigid bodies on springs and dampers.
#pragma once

#include "solid_solver/models/sprung/sprung_body.hpp"

namespace cosurge::sprung {

/// Nodes are those of the bodies (SprungBody), body after body.
template <int dim>
class SprungModel : public SolidModel {
 public:
  /// @throws Error for a pivot beside the centre of mass of a body that may move along an axis, too.
  SprungModel(const Structure<dim>& structure, const SprungParameters<dim>& parameters);

  Eigen::Index nodes() const override { return static_cast<Eigen::Index>(bodies_.size()) * per_body; }
  std::uint64_t particles() const override { return sites_.size(); }
  Interpolation interpolation(const Field& position, const std::vector<int>& body) const override;
  double substep() const override { return 0; }

  /// Returns the largest number of sub-steps that a body's rotation took.
  int advance(const Window& window, const NodalLoad& load) override;
  Field displacement() const override { return of_bodies(&SprungBody<dim>::displacement); }
  Field velocity() const override { return of_bodies(&SprungBody<dim>::velocity); }
  Field ramp_increment() const override { return of_bodies(&SprungBody<dim>::ramp_increment); }
  Field acceleration_by(const Field& load) const override;
  NodeLayout layout() const override;
  Field inertia(const Field& acceleration) const override;
  double max_speed() const override;
  Energies energies() const override;

  std::vector<NodalMode> modes(int count) const override;

  /// Total load on all bodies at the end of the window [N].
  std::vector<Column> columns() const override;
  std::vector<double> values() const override;

  std::string save() const override;
  void restore(const std::string& state) override;
  Snapshot frame() const override;

 private:
  static constexpr int per_body = SprungBody<dim>::nodes;

  /// A particle of the frames.
  struct Site {
    std::size_t body;
    Vec<dim> position;
    typename SprungBody<dim>::Coefficients coefficients;
  };

  Field of_bodies(Field (SprungBody<dim>::*part)() const) const;

  std::vector<SprungBody<dim>> bodies_;
  std::vector<Site> sites_;
  Vec<dim> total_load_ = Vec<dim>::Zero();
};

}  // namespace cosurge::sprung
