#include "common/case/snap_probes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/case/probe_mount.hpp"

namespace cosurge {
namespace {

/// The point of a shape that is nearest to another point.
struct Nearest {
  int body = -1;
  double distance = std::numeric_limits<double>::infinity();
  std::vector<double> point;
};

template <int dim>
Nearest nearest_of(const v1::Shape& shape, const Vec<dim>& x) {
  const Vec<dim> on = from_case<dim>(shape).nearest(x);
  return {.distance = (on - x).norm(), .point = {on.begin(), on.end()}};
}

template <int dim>
Nearest nearest_point(const v1::Solid& solid, const Vec<dim>& x) {
  Nearest nearest;
  for (int b = 0; b < solid.body_size(); ++b) {
    Nearest candidate = nearest_of(shape_of(solid.body(b)), x);
    if (candidate.distance >= nearest.distance) continue;
    candidate.body = b;
    nearest = candidate;
  }
  return nearest;
}

Nearest nearest_point(const v1::Case& c, const v1::Probe& probe) {
  return c.dimension() == 2 ? nearest_point<2>(c.solid(), from_case<2>(probe.position()))
                            : nearest_point<3>(c.solid(), from_case<3>(probe.position()));
}

std::string text(const std::vector<double>& point) {
  std::vector<std::string> numbers;
  for (const double value : point) numbers.push_back(fmt::format("{:.6g}", value));
  return fmt::format("({})", fmt::join(numbers, ", "));
}

/// Whether each has what its rules (common/case/case_rules.hpp) ask for: they are checked later.
bool bodies_have_shapes(const v1::Case& c) {
  return std::all_of(c.solid().body().begin(), c.solid().body().end(), [&](const v1::Body& body) {
    const v1::Shape shape = shape_of(body);
    return body.has_box() != body.has_shape() &&
           ((shape.min_size() == c.dimension() && shape.max_size() == c.dimension()) ||
            shape.vertex_size() >= 2 * c.dimension());
  });
}

}  // namespace

void snap_probes(v1::Case& c) {
  if (c.solid().body().empty() || !bodies_have_shapes(c)) return;
  constexpr double rounding = 0.01;
  const double reach = rounding * (c.has_fluid() ? c.fluid().spacing() : c.solid().spacing());
  for (v1::Probe& probe : *c.mutable_output()->mutable_probe()) {
    if (probe.quantity() == v1::Probe::level || body_at(c.solid(), probe.position()) >= 0) continue;
    const Nearest nearest = nearest_point(c, probe);
    if (nearest.distance < reach)
      probe.mutable_position()->Assign(nearest.point.begin(), nearest.point.end());
  }
}

std::string nearest_body(const v1::Case& c, const v1::Probe& probe) {
  const Nearest nearest = nearest_point(c, probe);
  if (nearest.body < 0) return "";
  return fmt::format("solid.body.{} is {:.3g} m away, at {}", nearest.body, nearest.distance,
                     text(nearest.point));
}

std::string too_deep(const v1::Case& c, const v1::Probe& probe) {
  const ProbeMount mount = mount_of(c, probe);
  const bool on_body = mount.on == ProbeMount::On::body;
  const v1::Shape shape =
      on_body ? shape_of(c.solid().body(mount.number)) : c.fluid().obstacle(mount.number).shape();
  const Nearest nearest = c.dimension() == 2 ? nearest_of<2>(shape, from_case<2>(probe.position()))
                                             : nearest_of<3>(shape, from_case<3>(probe.position()));
  constexpr double rounding = 1e-6;
  if (nearest.distance <= (1 + rounding) * c.fluid().spacing()) return "";
  return fmt::format(
      "lies {:.3g} m inside {}: pressure is measured on its surface, whose nearest point is {}; move the "
      "probe there",
      nearest.distance, on_body ? "a body" : fmt::format("fluid.obstacle.{}", mount.number),
      text(nearest.point));
}

}  // namespace cosurge
