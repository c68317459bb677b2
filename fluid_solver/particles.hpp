// The particles of the fluid solver: structure of arrays, kept in the order of the cells that they lie in.
#pragma once

#include <cstdint>
#include <vector>

#include "common/ordered_sum.hpp"
#include "common/vec.hpp"

namespace cosurge::fluid {

enum class Kind : std::uint8_t {
  fluid,
  wall,          ///< first layer of a fixed wall, with pressure
  dummy,         ///< the layers behind it, which complete the number density
  body_surface,  ///< wet point of a structure, with pressure and an area vector
  body_inner,    ///< inner point of a structure: a moving dummy
};

/// Whether a particle of this kind carries a pressure.
constexpr bool has_pressure(Kind kind) { return kind != Kind::dummy && kind != Kind::body_inner; }

/// Whether a particle of this kind belongs to a structure.
constexpr bool of_body(Kind kind) { return kind == Kind::body_surface || kind == Kind::body_inner; }

/// All particles of the fluid solver; entry k of every array belongs to the particle in place k.
template <int dim>
struct Particles {
  std::vector<Vec<dim>> x;  ///< position [m]
  std::vector<Vec<dim>> u;  ///< velocity [m/s]
  std::vector<double> p;    ///< pressure [Pa]
  std::vector<double> n;    ///< number density [-], for particles with pressure
  /// Unit normal of the face of a wall or body, towards the water, for the particle that the face belongs to;
  /// zero where it is unknown, and for water.
  std::vector<Vec<dim>> normal;
  std::vector<Kind> kind;
  std::vector<std::int32_t> id;  ///< number in the initial order, which never changes
  std::vector<std::uint8_t> free_surface;

  int size() const { return static_cast<int>(x.size()); }

  void add(Kind new_kind, const Vec<dim>& position) {
    id.push_back(size());
    x.push_back(position);
    u.push_back(Vec<dim>::Zero());
    p.push_back(0);
    n.push_back(0);
    normal.push_back(Vec<dim>::Zero());
    kind.push_back(new_kind);
    free_surface.push_back(0);
  }

  /// Moves particle order[k] to place k; particles that are not in `order` are removed.
  void reorder(const std::vector<std::int32_t>& order) {
    pick(x, order);
    pick(u, order);
    pick(p, order);
    pick(n, order);
    pick(normal, order);
    pick(kind, order);
    pick(id, order);
    pick(free_surface, order);
  }

 private:
  template <typename T>
  static void pick(std::vector<T>& values, const std::vector<std::int32_t>& order) {
    std::vector<T> picked(order.size());
    const int count = static_cast<int>(order.size());
#pragma omp parallel for schedule(static) if (count >= parallel_from)
    for (int k = 0; k < count; ++k) picked[k] = values[order[k]];
    values.swap(picked);
  }
};

}  // namespace cosurge::fluid
