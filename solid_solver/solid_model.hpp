// Interface of a solid model: unknowns at nodes that move under loads.
#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// H: one row a point, one column a node. Motion goes from nodes to points by u = q H^T, loads come back by
/// f_q = f H, so that both do the same work (docs/method_solid.md, S16).
using Interpolation = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Force on the nodes [N], dimension x nodes: it goes linearly from `first` to `last` over the window.
struct NodalLoad {
  Field first;
  Field last;
};

/// A mode of vibration about the undeformed bodies.
struct NodalMode {
  Field shape;               ///< dimension x nodes
  double mass = 1;           ///< [kg] of the mode
  double omega_squared = 0;  ///< [1/s2]; 0 where nothing holds the body
};

/// Where the nodes of a model are where the bodies are undeformed, and which body is whose.
struct NodeLayout {
  Field position;                  ///< positions of the nodes, dimension x nodes [m]
  std::vector<int> body;           ///< body of each node
  std::vector<int> particle_body;  ///< body of each particle in a frame
};

struct Energies {
  double kinetic = 0;  ///< [J], per metre of width in two dimensions
  double elastic = 0;  ///< [J]
  double gravity = 0;  ///< [J] zero in the reference configuration

  Energies& operator+=(const Energies& other) {
    kinetic += other.kinetic;
    elastic += other.elastic;
    gravity += other.gravity;
    return *this;
  }
};

/// A discretised structure. Motion is the displacement of the nodes from the reference configuration.
class SolidModel {
 public:
  virtual ~SolidModel() = default;

  /// Columns of displacement and load.
  virtual Eigen::Index nodes() const = 0;

  /// Particles of a frame.
  virtual std::uint64_t particles() const = 0;

  /// H for points of the reference configuration that belong to the given bodies. Rows sum to one and are
  /// exact for affine motion, except for points in a held region, whose row may be empty.
  /// @throws Error for a point that the body does not reach.
  virtual Interpolation interpolation(const Field& position, const std::vector<int>& body) const = 0;

  /// The sub-step that this model takes where the window allows [s]; 0 where it takes the window.
  virtual double substep() const = 0;

  /// Sub-cycles over one window; returns their number n. Sub-step k sees first + s_k (last - first), the
  /// impulse of the linear load (S14): s_k = (k + 1/2) / n, or the instant at which the model balances its
  /// forces.
  /// @throws NumericalError where the motion runs away.
  virtual int advance(const Window& window, const NodalLoad& load) = 0;

  virtual Field displacement() const = 0;  ///< [m] dimension x nodes, at the end of the last window

  virtual Field velocity() const = 0;  ///< [m/s] dimension x nodes, at the end of the last window

  /// sum over sub-steps k of s_k dq_k in the last window [m]: what ramped loads work on (S15).
  virtual Field ramp_increment() const = 0;

  /// M^-1 f: what loads on the nodes [N] accelerate them by where nothing else acts, about the undeformed
  /// bodies [m/s2]; held nodes by nothing.
  virtual Field acceleration_by(const Field& load) const = 0;

  virtual NodeLayout layout() const = 0;

  /// M a: the forces on the nodes that give them an acceleration, dimension x nodes; those of held nodes
  /// count among the accelerations [N].
  virtual Field inertia(const Field& acceleration) const = 0;

  /// Where in a sub-step, as a share of it, displacements go on with the present velocity until a force that
  /// depends on them and is held over the sub-step neither gives nor takes energy (S45).
  virtual double force_instant() const { return 0.5; }

  virtual double max_speed() const = 0;  ///< [m/s] of the nodes
  virtual Energies energies() const = 0;

  /// The lowest modes, at most `count` of each body, where the model knows them, as they would answer a load
  /// now, seen from what carries the bodies; none for others.
  virtual std::vector<NodalMode> modes(int /*count*/) const { return {}; }

  /// Quantities of this model alone, reported after every window.
  virtual std::vector<Column> columns() const { return {}; }
  virtual std::vector<double> values() const { return {}; }

  /// Messages of the model on the last window; empty afterwards.
  virtual std::vector<std::string> take_notes() { return {}; }

  /// The complete state: after restore(save()) results are bit-identical.
  virtual std::string save() const = 0;
  virtual void restore(const std::string& state) = 0;

  virtual Snapshot frame() const = 0;
};

}  // namespace cosurge
