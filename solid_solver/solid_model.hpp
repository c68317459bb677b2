// Interface of a solid model: unknowns at nodes that move under loads.
#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "common/participant.hpp"

namespace cosurge {

/// H: one matrix row for each point, one column for each node. The motion of the nodes is mapped to the
/// points by u = q H^T, and loads are mapped back by f_q = f H, so that both do the same work
/// (docs/method_solid.md, S16).
using Interpolation = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Force on the nodes [N], dimension x nodes. It changes linearly from `first` to `last` over the window.
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

/// Positions of a model's nodes in the undeformed bodies, and the body of each node and particle.
struct NodeLayout {
  Field position;                  ///< positions of the nodes, dimension x nodes [m]
  std::vector<int> body;           ///< body of each node
  std::vector<int> particle_body;  ///< body of each particle in a frame
};

/// Energies of the bodies.
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

  /// Number of nodes, the columns of displacement and load.
  virtual Eigen::Index nodes() const = 0;

  /// Number of particles in a frame.
  virtual std::uint64_t particles() const = 0;

  /// H for points of the reference configuration that belong to the given bodies. Its matrix rows sum to one
  /// and are exact for affine motion, except for points in a held region, whose row may be empty.
  /// @throws Error for a point that the body does not reach.
  virtual Interpolation interpolation(const Field& position, const std::vector<int>& body) const = 0;

  /// The model's own sub-step [s]; 0 if it takes the whole window.
  virtual double substep() const = 0;

  /// Computes one window in n sub-steps and returns n. Sub-step k has the load first + s_k (last - first),
  /// with the impulse of the linear load (S14): s_k = (k + 1/2) / n, or the instant at which the model
  /// balances its forces.
  /// @throws NumericalError if the motion becomes unstable.
  virtual int advance(const Window& window, const NodalLoad& load) = 0;

  virtual Field displacement() const = 0;  ///< [m] dimension x nodes, at the end of the last window

  virtual Field velocity() const = 0;  ///< [m/s] dimension x nodes, at the end of the last window

  /// z of (S15), the sum over the sub-steps k of s_k dq_k in the last window [m], dimension x nodes.
  virtual Field ramp_increment() const = 0;

  /// M^-1 f: the acceleration of the nodes by the loads f [N] alone, about the undeformed bodies [m/s2]; zero
  /// for held nodes.
  virtual Field acceleration_by(const Field& load) const = 0;

  virtual NodeLayout layout() const = 0;

  /// M a: the forces on the nodes that cause the acceleration a, dimension x nodes, including the
  /// accelerations of held nodes [N].
  virtual Field inertia(const Field& acceleration) const = 0;

  /// The instant within a sub-step, as a share of it, for a displacement-dependent force that is held over
  /// the sub-step: evaluated at displacements extrapolated to this instant with the present velocity, the
  /// force conserves its energy (c of S45).
  virtual double force_instant() const { return 0.5; }

  virtual double max_speed() const = 0;  ///< [m/s] of the nodes
  virtual Energies energies() const = 0;

  /// The lowest modes, at most `count` of each body, as they would respond to a load in the present state, in
  /// the frame of the bodies' carriers; none if the model does not know its modes.
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
