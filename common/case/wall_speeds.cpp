#include "common/case/wall_speeds.hpp"

#include <algorithm>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"

namespace cosurge {
namespace {

/// A box that moves by a prescribed motion.
template <int dim>
struct Driven {
  Motion<dim> motion;
  Box<dim> box;
};

template <int dim>
std::vector<Driven<dim>> driven_boxes(const v1::Case& c) {
  std::vector<Driven<dim>> all;
  const auto add = [&](const v1::WallMotion& motion, const Box<dim>& box) {
    if (const auto prescribed = from_case<dim>(motion); prescribed.moves()) all.push_back({prescribed, box});
  };
  for (const v1::Obstacle& obstacle : c.fluid().obstacle())
    if (obstacle.has_motion()) add(obstacle.motion(), from_case<dim>(obstacle.shape()).bounds());
  for (const v1::Body& body : c.solid().body())
    if (body.has_motion()) add(body.motion(), from_case<dim>(shape_of(body)).bounds());
  return all;
}

template <int dim>
double fastest_corner(const Driven<dim>& driven, double t) {
  double fastest = 0;
  for (int corner = 0; corner < 1 << dim; ++corner) {
    Vec<dim> x;
    for (int k = 0; k < dim; ++k) x[k] = (corner >> k & 1) != 0 ? driven.box.max[k] : driven.box.min[k];
    fastest = std::max(fastest, driven.motion.velocity(x, t).norm());
  }
  return fastest;
}

template <int dim>
std::vector<double> speeds(const v1::Case& c) {
  constexpr int instants = 500;
  const std::vector<Driven<dim>> boxes = driven_boxes<dim>(c);
  if (boxes.empty()) return {};
  std::vector<double> fastest(instants, 0.0);
  for (int k = 0; k < instants; ++k)
    for (const Driven<dim>& driven : boxes)
      fastest[static_cast<std::size_t>(k)] =
          std::max(fastest[static_cast<std::size_t>(k)],
                   fastest_corner(driven, (k + 0.5) / instants * c.time().end()));
  return fastest;
}

}  // namespace

std::vector<double> driven_speeds(const v1::Case& the_case) {
  return the_case.dimension() == 2 ? speeds<2>(the_case) : speeds<3>(the_case);
}

}  // namespace cosurge
