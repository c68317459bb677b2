// Rotation of a rigid body about its pivot.
#pragma once

#include <optional>
#include <vector>

#include "common/state_bytes.hpp"
#include "solid_solver/models/sprung/space_turning.hpp"
#include "solid_solver/models/sprung/turning.hpp"
#include "solid_solver/solid_model.hpp"
#include "solid_solver/structure.hpp"

namespace cosurge::sprung {

/// Held, or free about one axis, or in space about all three; by any angle. Nodes are the pivot and a point
/// at `length` from it along each axis.
template <int dim>
class Revolution {
 public:
  static constexpr int nodes = dim + 1;
  using Nodal = Eigen::Matrix<double, dim, nodes>;

  /// Springs of the rotations: in the plane; in space about x, y and z, one of them or all.
  using Springs = std::array<std::optional<Spring>, dim == 2 ? 1 : 3>;

  /// @param second integral of the density times X (x) X from the pivot [kg m2]
  /// @param length of the nodes' arms [m]
  Revolution(const Springs& springs, const Mat<dim>& second, double length);

  bool is_free() const { return single_ || space_; }

  /// Computes a window under a load on the nodes that changes linearly from first to last [N], and a weight
  /// [N] at a lever arm from the pivot [m]. Returns the number of sub-steps. `ramp_increment` gets the
  /// integral z of (S15).
  int advance(double window, const Nodal& first, const Nodal& last, const Vec<dim>& arm,
              const Vec<dim>& weight, Nodal& ramp_increment);

  Nodal displacement() const {
    return arms(rotation() - Mat<dim>::Identity());
  }                        ///< displacement of the nodes [m]
  Nodal velocity() const;  ///< [m/s]
  double kinetic_energy() const;
  double spring_energy() const;
  std::vector<NodalMode> modes() const;  ///< small rotations about the present position

  void save(StateWriter& state) const;
  void restore(StateReader& state);

 private:
  struct Loads {
    Nodal nodal;
    Vec<dim> arm, weight;
  };

  Mat<dim> rotation() const;
  Nodal arms(const Mat<dim>& turned) const;
  int substeps(double window) const;
  void step(const Loads& loads, double dt);
  NodalMode mode(const Mat<dim>& spin, double inertia, double stiffness) const;

  double length_;
  Mat<dim> generator_ = Mat<dim>::Zero();  // generator of a rotation about one axis: dX/dtheta = generator X
  std::optional<Turning> single_;
  std::optional<SpaceTurning> space_;
};

}  // namespace cosurge::sprung
