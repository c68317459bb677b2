// Supports of a body: points that are held along some axes.
#pragma once

#include <array>
#include <vector>

#include "common/error.hpp"
#include "common/geometry/lattice.hpp"

namespace cosurge {

template <int dim>
using Axes = std::array<bool, dim>;

/// Boxes in which the points of a body's discretisation are held along some axes (Body.support of the case).
template <int dim>
class Supports {
 public:
  /// @param margin by which a point may lie outside a box and still be held [m]
  Supports(const v1::Body& body, double margin) {
    const Vec<dim> widen = Vec<dim>::Constant(margin);
    for (const v1::Support& support : body.support()) {
      const Box<dim> box(support.box());
      supports_.push_back({.box = Box<dim>(box.min - widen, box.max + widen), .along = {}});
      Axes<dim>& along = supports_.back().along;
      along.fill(support.along_size() == 0);
      for (const int axis : support.along()) along.at(static_cast<std::size_t>(axis)) = true;
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
  void require_points(const Points& points, int body, const char* what) const {
    for (std::size_t s = 0; s < supports_.size(); ++s) {
      const auto inside = [&](const Vec<dim>& x) { return supports_[s].box.contains(x); };
      require(std::any_of(points.begin(), points.end(), inside),
              "solid.body.{}.support.{}: no {} of the body lies in its box; make it larger", body, s, what);
    }
  }

 private:
  struct Support {
    Box<dim> box;
    Axes<dim> along;
  };
  std::vector<Support> supports_;
};

}  // namespace cosurge
