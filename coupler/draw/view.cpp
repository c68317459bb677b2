#include "coupler/draw/view.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {
namespace {

constexpr double azimuth = -1.0, elevation = 0.42;  // rad: as the page begins

/// To the right, up and towards the eye, from the middle.
struct Seen {
  double right;
  double up;
  double near;
};

Seen seen(const Place& place, const Place& middle) {
  const double x = place[0] - middle[0], y = place[1] - middle[1];
  if (place.size() == 2) return {.right = x, .up = y, .near = 0};
  const double z = place[2] - middle[2];
  const double ca = std::cos(azimuth), sa = std::sin(azimuth), ce = std::cos(elevation),
               se = std::sin(elevation);
  return {.right = -sa * x + ca * y,
          .up = -ca * se * x - sa * se * y + ce * z,
          .near = ca * ce * x + sa * ce * y + se * z};
}

Place middle_of(const Region& region) {
  Place middle;
  for (std::size_t axis = 0; axis < region.min.size(); ++axis)
    middle.push_back(0.5 * (region.min[axis] + region.max[axis]));
  return middle;
}

/// Half the width and height of a region as it is seen.
std::pair<double, double> half_sizes(const Region& region) {
  const Place middle = middle_of(region);
  double right = 0, up = 0;
  const std::size_t dimension = middle.size();
  for (unsigned corner = 0; corner < 1U << dimension; ++corner) {
    Place place;
    for (std::size_t axis = 0; axis < dimension; ++axis)
      place.push_back(corner >> axis & 1U ? region.max[axis] : region.min[axis]);
    const Seen at = seen(place, middle);
    right = std::max(right, std::abs(at.right));
    up = std::max(up, std::abs(at.up));
  }
  return {right, up};
}

}  // namespace

void Region::add(const Place& place) {
  for (std::size_t axis = 0; axis < min.size(); ++axis) {
    min[axis] = std::min(min[axis], place[axis]);
    max[axis] = std::max(max[axis], place[axis]);
  }
}

double Region::largest_size() const {
  double largest = 0;
  for (std::size_t axis = 0; axis < min.size(); ++axis) largest = std::max(largest, size(axis));
  return largest;
}

Region Region::grown(double by) const {
  Region larger = *this;
  for (std::size_t axis = 0; axis < min.size(); ++axis) larger.min[axis] -= by, larger.max[axis] += by;
  return larger;
}

View::View(const Region& region, const Rectangle& area) : middle_(middle_of(region)), area_(area) {
  const auto [right, up] = half_sizes(region);
  scale_ = std::min(area.width / std::max(2 * right, 1e-12), area.height / std::max(2 * up, 1e-12));
}

Pixel View::pixel(const Place& place) const {
  const Seen at = seen(place, middle_);
  return {area_.left + area_.width / 2 + scale_ * at.right, area_.top + area_.height / 2 - scale_ * at.up};
}

double View::nearness(const Place& place) const { return seen(place, middle_).near; }

double View::aspect(const Region& region) {
  const auto [right, up] = half_sizes(region);
  return up / std::max(right, 1e-12);
}

}  // namespace cosurge
