// Supports of a body: points that are held along some axes.
#pragma once

#include <array>
#include <vector>

#include "common/error.hpp"
#include "common/geometry/lattice.hpp"

namespace cosurge {

template <int dim>
using Axes = std::array<bool, dim>;

/// A box in which the points of a body's discretisation are held along some axes.
template <int dim>
struct Support {
  Box<dim> box;
  Axes<dim> along;
};

/// All supports of a body.
template <int dim>
class Supports {
 public:
  /// @param margin by which a point may lie outside a box and still be held [m]
  Supports(const std::vector<Support<dim>>& supports, double margin) : supports_(supports) {
    for (Support<dim>& support : supports_) {
      support.box.min.array() -= margin;
      support.box.max.array() += margin;
    }
  }

  /// Axes along which a point is held.
  Axes<dim> held(const Vec<dim>& x) const {
    Axes<dim> held = {};
    for (const auto& [box, along] : supports_)
      for (std::size_t k = 0; k < dim; ++k) held[k] = held[k] || (along[k] && box.contains(x));
    return held;
  }

  /// @throws Error for a support that holds none of the points; `what` they are, for the message.
  template <typename Points>
  void require_points(const Points& points, std::size_t body, const char* what) const {
    for (std::size_t s = 0; s < supports_.size(); ++s) {
      const auto inside = [&](const Vec<dim>& x) { return supports_[s].box.contains(x); };
      require(std::any_of(points.begin(), points.end(), inside),
              "solid.body.{}.support.{}: no {} of the body lies in its box; make it larger", body, s, what);
    }
  }

 private:
  std::vector<Support<dim>> supports_;
};

}  // namespace cosurge
