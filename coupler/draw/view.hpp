// From places of the scene to pixels, in two and three dimensions. Up is the last coordinate.
#pragma once

#include <limits>

#include "coupler/draw/canvas.hpp"

namespace cosurge {

/// x, y and, in three dimensions, z [m].
using Place = std::vector<double>;

/// A region of the scene that has no points at first.
struct Region {
  Place min;
  Place max;

  explicit Region(int dimension)
      : min(static_cast<std::size_t>(dimension), std::numeric_limits<double>::infinity()),
        max(static_cast<std::size_t>(dimension), -std::numeric_limits<double>::infinity()) {}

  void add(const Place& place);
  bool empty() const { return !(min[0] <= max[0]); }
  double size(std::size_t axis) const { return max[axis] - min[axis]; }
  double largest_size() const;
  /// Larger by a distance on all sides.
  Region grown(double by) const;
};

/// Parallel projection of a region into an area of a picture. In three dimensions one looks down on it from
/// the front and the right.
class View {
 public:
  View(const Region& region, const Rectangle& area);

  Pixel pixel(const Place& place) const;
  /// Distance towards the eye [m]; 0 in two dimensions.
  double nearness(const Place& place) const;
  double pixels_a_metre() const { return scale_; }
  int dimension() const { return static_cast<int>(middle_.size()); }
  const Rectangle& area() const { return area_; }

  /// Height over width of a region as it is seen.
  static double aspect(const Region& region);

 private:
  Place middle_;
  Rectangle area_;
  double scale_ = 1;
};

}  // namespace cosurge
