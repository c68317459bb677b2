// The water's load on an obstacle or on a side of the tank.
#pragma once

#include <utility>

#include "common/geometry/probe_mount.hpp"
#include "fluid_solver/face_pieces.hpp"
#include "fluid_solver/load.hpp"
#include "fluid_solver/mps.hpp"

namespace cosurge::fluid {

/// Sums the pressure over the face, in pieces of half a spacing. The pressure on a piece is interpolated from
/// the wall particles behind it and extrapolated to the face as in eq. (15). Friction and collisions are
/// added. Pieces inside another wall, or touched by a body, count as dry.
template <int dim>
class WallLoad {
 public:
  /// @param mount an obstacle or a side of the tank
  /// @param about the point about which the moment is taken, at the start; it moves with the wall [m]
  WallLoad(const Mps<dim>& mps, const ProbeMount& mount, const Vec<dim>& about);

  /// The load at time `t` [s]. `place` is the place of each particle by id.
  Load<dim> read(const Mps<dim>& mps, const std::vector<std::int32_t>& place, double t) const;

 private:
  struct Piece : FacePiece<dim> {
    std::vector<std::pair<std::int32_t, double>> behind;  // ids and weights of the wall particles behind it
  };

  double pressure(const Mps<dim>& mps, const std::vector<std::int32_t>& place, const Piece& piece,
                  const Vec<dim>& x) const;
  bool dry(const Mps<dim>& mps, const Vec<dim>& x, const Vec<dim>& normal, double t) const;

  std::size_t part_;  // index among the wall parts
  Vec<dim> about_;
  double spacing_;
  std::vector<Piece> pieces_;
  std::vector<std::int32_t> ids_;  // of the wall particles behind the whole face
};

}  // namespace cosurge::fluid
