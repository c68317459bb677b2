// The faces that water sees at an edge.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "common/vec.hpp"

namespace cosurge::fluid {

/// At a convex edge of a wall or body, water lies before one face and behind the other, which the first one
/// hides. It slides along the face that it sees: the hidden face must neither stop nor draw it.
template <int dim>
class SeenFaces {
 public:
  explicit SeenFaces(double spacing) : half_spacing_(0.5 * spacing) {}

  /// Adds a point of a wall or body with the unit normal `normal`; `way` leads from the water to the point
  /// [m]. `first_layer`: the face lies half a spacing before the point.
  void add(const Vec<dim>& normal, const Vec<dim>& way, bool first_layer) {
    if (normal.isZero()) return;
    if (first_.isZero()) first_ = normal;
    differ_ = differ_ || first_.dot(normal) < about_the_same;
    if (!first_layer || -normal.dot(way) < half_spacing_) return;
    if (const double square = way.squaredNorm(); square < nearest_square_) {
      nearest_square_ = square;
      nearest_ = normal;
    }
    if (!is_seen(normal) && count_ < seen_.size()) seen_[count_++] = normal;
  }

  /// Whether points have different normals, and a face is seen.
  bool at_edge() const { return differ_ && count_ > 0; }

  /// The normal with which the water sees a point with the normal `own`: its own, if a face with about this
  /// normal is seen, otherwise that of the nearest seen face.
  const Vec<dim>& normal(const Vec<dim>& own) const {
    return !at_edge() || own.isZero() || is_seen(own) ? own : nearest_;
  }

 private:
  bool is_seen(const Vec<dim>& normal) const {
    for (std::size_t k = 0; k < count_; ++k)
      if (seen_[k].dot(normal) > about_the_same) return true;
    return false;
  }

  static constexpr double about_the_same = 0.8;  // 37 degrees: the normals within the radius on a curved face

  double half_spacing_;
  Vec<dim> first_ = Vec<dim>::Zero();
  bool differ_ = false;
  double nearest_square_ = std::numeric_limits<double>::infinity();
  Vec<dim> nearest_ = Vec<dim>::Zero();
  std::array<Vec<dim>, 8> seen_;
  std::size_t count_ = 0;
};

}  // namespace cosurge::fluid
