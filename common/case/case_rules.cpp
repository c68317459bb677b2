#include "common/case/case_rules.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "common/case/bodies.hpp"
#include "common/case/motion_rules.hpp"
#include "common/case/outline_rules.hpp"
#include "common/case/probe_rules.hpp"
#include "common/case/region_rules.hpp"
#include "common/case/spring_rules.hpp"
#include "common/error.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

constexpr double whole = 1e-6;  // [spacings] tolerance for quotients of decimal numbers such as 0.146 / 0.002

bool divides(double spacing, double length) {
  const double quotient = length / spacing;
  const double nearest = std::round(quotient);
  return (nearest != 0 || length == 0) &&
         std::abs(quotient - nearest) < whole * std::max(1.0, std::abs(quotient));
}

/// A box of the case, with its key.
struct NamedBox {
  std::string key;
  v1::Box box;
  bool unscaled_outline = false;  // it is the box around an outline as it is in its file
};

/// A shape, or the box around its outline.
NamedBox named_box(const std::string& key, const v1::Shape& shape, int dimension) {
  NamedBox named{.key = key, .box = {}, .unscaled_outline = shape.vertex_size() > 0 && !shape.has_scale()};
  *named.box.mutable_min() = shape.min();
  *named.box.mutable_max() = shape.max();
  for (int v = 0; v < shape.vertex_size(); ++v) {
    const int k = v % dimension;
    if (v < dimension) {
      named.box.add_min(shape.vertex(v));
      named.box.add_max(shape.vertex(v));
    }
    named.box.set_min(k, std::min(named.box.min(k), shape.vertex(v)));
    named.box.set_max(k, std::max(named.box.max(k), shape.vertex(v)));
  }
  return named;
}

bool is_box(const v1::Shape& shape) { return shape.vertex().empty(); }

/// Box of each body, or of its outline.
std::vector<NamedBox> body_bounds(const v1::Solid& solid, int dimension) {
  std::vector<NamedBox> bounds;
  for (int i = 0; i < solid.body_size(); ++i)
    bounds.push_back(named_box(body_key(solid, i), shape_of(solid.body(i)), dimension));
  return bounds;
}

std::vector<NamedBox> body_boxes(const v1::Solid& solid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < solid.body_size(); ++i)
    if (const v1::Shape shape = shape_of(solid.body(i)); is_box(shape))
      boxes.push_back(named_box(body_key(solid, i), shape, 0));
  return boxes;
}

std::vector<NamedBox> water_boxes(const v1::Fluid& fluid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < fluid.water_size(); ++i)
    if (is_box(fluid.water(i)))
      boxes.push_back(named_box(fmt::format("fluid.water.{}", i), fluid.water(i), 0));
  return boxes;
}

std::vector<NamedBox> obstacle_boxes(const v1::Fluid& fluid) {
  std::vector<NamedBox> boxes;
  for (int i = 0; i < fluid.obstacle_size(); ++i)
    if (is_box(fluid.obstacle(i).shape()))
      boxes.push_back(named_box(fmt::format("fluid.obstacle.{}.shape", i), fluid.obstacle(i).shape(), 0));
  return boxes;
}

bool overlap(const v1::Box& a, const v1::Box& b, double margin) {
  for (int k = 0; k < a.min_size(); ++k)
    if (a.max(k) <= b.min(k) + margin || b.max(k) <= a.min(k) + margin) return false;
  return true;
}

bool inside(const v1::Box& inner, const v1::Box& outer, double margin) {
  for (int k = 0; k < inner.min_size(); ++k)
    if (inner.min(k) < outer.min(k) - margin || inner.max(k) > outer.max(k) + margin) return false;
  return true;
}

/// The nearest spacing below (step = +1) or above (-1) the given one that divides every length, searched as
/// fractions of the shortest length.
std::optional<double> nearest_spacing(double spacing, const std::vector<double>& lengths, int step) {
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  const auto fits = [&](double s) {
    return std::all_of(lengths.begin(), lengths.end(), [&](double length) { return divides(s, length); });
  };
  const int parts =
      static_cast<int>(step > 0 ? std::ceil(shortest / spacing) : std::floor(shortest / spacing));
  constexpr int search = 2000;
  for (int n = parts; n > 0 && n < parts + search; n += step)
    if (fits(shortest / n)) return shortest / n;
  return std::nullopt;
}

void check_spacing(const std::string& key, double spacing, const std::vector<NamedBox>& boxes,
                   CaseErrors& errors) {
  std::vector<double> lengths;
  std::vector<std::string> wrong, rounded;
  double farthest = 0;
  std::string farthest_key;
  for (const NamedBox& named : boxes) {
    for (int k = 0; k < named.box.min_size(); ++k) {
      for (const double value : {named.box.min(k), named.box.max(k)}) {
        if (value != 0) lengths.push_back(std::abs(value));
        if (std::abs(value) > farthest) {
          farthest = std::abs(value);
          farthest_key = fmt::format("the coordinate {} of {}", value, named.key);
        }
        if (divides(spacing, value)) continue;
        wrong.push_back(fmt::format("{} ({:.6g} is {:.4g} spacings)", named.key, value, value / spacing));
        rounded.push_back(fmt::format("{:.6g} to {:.6g}", value, std::round(value / spacing) * spacing));
      }
    }
  }
  constexpr double finest = 1e5;  // spacings along a side: no memory holds more
  if (farthest > finest * spacing)
    return errors.add(key, fmt::format("{} must be >= {:.6g} [m]: {} is {:.3g} spacings, at most {:.0f} are "
                                       "possible",
                                       spacing, farthest / finest, farthest_key, farthest / spacing, finest));
  if (wrong.empty()) return;
  const auto below = nearest_spacing(spacing, lengths, 1);
  const auto above = nearest_spacing(spacing, lengths, -1);
  errors.add(key,
             fmt::format("{} does not divide {}; the nearest values that divide every box are {} below and "
                         "{} above; or round {}, or give the shape as an outline, which need not fit",
                         spacing, fmt::join(wrong, ", "), below ? fmt::format("{:.6g}", *below) : "none",
                         above ? fmt::format("{:.6g}", *above) : "none", fmt::join(rounded, ", ")));
}

bool check_boxes_ordered(const std::vector<NamedBox>& boxes, CaseErrors& errors) {
  bool ok = true;
  for (const NamedBox& named : boxes) {
    for (int k = 0; k < named.box.min_size(); ++k) {
      if (named.box.min(k) < named.box.max(k)) continue;
      errors.add(named.key, fmt::format("min {} must be < max {} in coordinate {}", named.box.min(k),
                                        named.box.max(k), k));
      ok = false;
    }
  }
  return ok;
}

/// Whether a shape is either a box or a closed outline.
bool check_shape(const std::string& key, const v1::Shape& shape, CaseErrors& errors) {
  const bool box = shape.min_size() > 0 && shape.max_size() > 0;
  const bool outline = !shape.vertex().empty() || shape.has_outline();
  std::string wrong;
  if (box == outline || (!box && shape.min_size() + shape.max_size() > 0))
    wrong = "must have either min and max, or outline";
  else if (outline)
    wrong = too_few_corners(shape, errors.dimension);
  if (wrong.empty() && outline) wrong = not_closed(shape, errors.dimension);
  if (!wrong.empty()) errors.add(key, wrong);
  return wrong.empty();
}

bool check_body_shapes(const v1::Solid& solid, CaseErrors& errors) {
  bool ok = true;
  for (int i = 0; i < solid.body_size(); ++i) {
    const v1::Body& body = solid.body(i);
    if (body.has_box() == body.has_shape()) {
      errors.add(fmt::format("solid.body.{}", i), "must have either box or shape");
      ok = false;
    } else {
      ok = check_shape(body_key(solid, i), shape_of(body), errors) && ok;
    }
    for (int j = 0; j < body.clamp_size(); ++j)
      ok = check_shape(fmt::format("solid.body.{}.clamp.{}", i, j), body.clamp(j), errors) && ok;
  }
  return ok;
}

bool check_shapes(const v1::Case& c, CaseErrors& errors) {
  bool ok = !c.has_solid() || check_body_shapes(c.solid(), errors);
  for (int i = 0; i < c.fluid().water_size(); ++i)
    ok = check_shape(fmt::format("fluid.water.{}", i), c.fluid().water(i), errors) && ok;
  for (int i = 0; i < c.fluid().obstacle_size(); ++i)
    ok = check_shape(fmt::format("fluid.obstacle.{}.shape", i), c.fluid().obstacle(i).shape(), errors) && ok;
  return ok;
}

/// Message for a box outside the tank: its position, and whether its file may be in mm.
std::string outside_the_tank(const NamedBox& named, const v1::Box& tank) {
  bool larger = false;
  for (int k = 0; k < tank.min_size(); ++k)
    larger = larger || named.box.max(k) - named.box.min(k) > tank.max(k) - tank.min(k);
  return fmt::format("must lie inside fluid.tank; it reaches from ({:.6g}) to ({:.6g}) m{}",
                     fmt::join(named.box.min(), ", "), fmt::join(named.box.max(), ", "),
                     larger && named.unscaled_outline ? "; if its file is in mm, set scale = 0.001" : "");
}

/// Boxes on the lattice; water and bodies in the tank and apart from each other.
void check_scene(const v1::Case& c, CaseErrors& errors) {
  std::vector<NamedBox> filled = body_boxes(c.solid()), boxes = filled, inner;
  if (c.has_fluid()) {
    for (const NamedBox& water : water_boxes(c.fluid())) filled.push_back(water);
    boxes = filled;
    for (const NamedBox& obstacle : obstacle_boxes(c.fluid())) boxes.push_back(obstacle);
    boxes.push_back({.key = "fluid.tank", .box = c.fluid().tank()});
    inner = body_bounds(c.solid(), c.dimension());
    for (const NamedBox& water : water_boxes(c.fluid())) inner.push_back(water);
  }
  if (!check_boxes_ordered(boxes, errors)) return;
  const std::size_t before = errors.lines.size();
  if (c.has_fluid()) {
    const double margin = whole * c.fluid().spacing();
    check_spacing("fluid.spacing", c.fluid().spacing(), boxes, errors);
    for (const NamedBox& named : inner)
      if (!inside(named.box, c.fluid().tank(), margin))
        errors.add(named.key, outside_the_tank(named, c.fluid().tank()));
    for (std::size_t i = 0; i < filled.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (overlap(filled[i].box, filled[j].box, margin))
          errors.add(filled[i].key, fmt::format("overlaps {}", filled[j].key));
  }
  if (c.solid().has_spacing() && !body_boxes(c.solid()).empty())
    check_spacing("solid.spacing", c.solid().spacing(), body_boxes(c.solid()), errors);
  if (errors.lines.size() != before || !check_sizes(c, errors)) return;
  check_outlined_bodies(c, errors);
  check_filled(c, errors);
  if (c.has_fluid()) check_obstacles(c, errors);
}

void check_fluid(const v1::Case& c, CaseErrors& errors) {
  const v1::Fluid& fluid = c.fluid();
  const auto& gravity = c.gravity();
  const bool weightless = std::all_of(gravity.begin(), gravity.end(), [](double g) { return g == 0; });
  if (fluid.source() == v1::Fluid::time_scale && !fluid.has_propagation_speed() && weightless)
    errors.add("fluid.propagation_speed", "missing (there is no gravity to take it from)");
  if (fluid.re_laplacian() > 2 * fluid.re_gradient())
    errors.add("fluid.re_laplacian", fmt::format("{} must be <= 2 fluid.re_gradient = {}",
                                                 fluid.re_laplacian(), 2 * fluid.re_gradient()));
}

/// Obstacles: water on one side must not see water on the other.
void check_thickness(const v1::Fluid& fluid, CaseErrors& errors) {
  const double layers = std::ceil(fluid.re_laplacian());
  for (const NamedBox& named : obstacle_boxes(fluid))
    for (int k = 0; k < named.box.min_size(); ++k)
      if (const double side = named.box.max(k) - named.box.min(k); side < (layers - whole) * fluid.spacing())
        errors.add(
            named.key,
            fmt::format("is {:.3g} spacings thick, must be at least {}: a spacing of {:.4g} m at most, or a "
                        "thicker obstacle",
                        side / fluid.spacing(), layers, side / layers));
}

void check_solid(const v1::Case& c, CaseErrors& errors) {
  const v1::Solid& solid = c.solid();
  if (!solid.has_spacing() && !c.has_fluid())
    return errors.add("solid.spacing", "missing (there is no fluid to take it from)");
  const bool deformable = solid.model() != v1::SolidModel::rigid && solid.model() != v1::SolidModel::sprung;
  if (deformable && !solid.has_young_modulus())
    errors.add("solid.young_modulus",
               fmt::format("missing, the model {} needs it", v1::SolidModel::Word_Name(solid.model())));
  const double spacing = solid.has_spacing() ? solid.spacing() : c.fluid().spacing();
  const double fluid_spacing = c.has_fluid() ? c.fluid().spacing() : spacing;
  if (solid.material() == v1::Solid::neo_hookean && solid.model() != v1::SolidModel::fem && deformable)
    errors.add("solid.material", fmt::format("neo_hookean is available for the model fem only, not for {}",
                                             v1::SolidModel::Word_Name(solid.model())));
  // Layers, so that water on one side does not see water on the other.
  const double fewest = std::max(3.0, c.has_fluid() ? std::ceil(c.fluid().re_laplacian()) - 1 : 0.0);
  const std::vector<NamedBox> bounds = body_bounds(solid, c.dimension());
  for (int i = 0; i < solid.body_size(); ++i) {
    const v1::Body& body = solid.body(i);
    const NamedBox& around = bounds[static_cast<std::size_t>(i)];
    for (int k = 0; k < around.box.min_size(); ++k) {
      const double side = around.box.max(k) - around.box.min(k);
      if (side < (fewest - whole) * fluid_spacing)
        errors.add(
            around.key,
            fmt::format("is {:.3g} spacings thick, must be at least {}: a spacing of {:.4g} m at most, or a "
                        "thicker body (plates with equal E h^3 and rho h bend alike, h the thickness)",
                        side / fluid_spacing, fewest, side / fewest));
    }
    for (int j = 0; j < body.clamp_size(); ++j) {
      const std::string key = fmt::format("solid.body.{}.clamp.{}", i, j);
      const NamedBox clamp = named_box(key, body.clamp(j), c.dimension());
      if (!check_boxes_ordered({clamp}, errors)) continue;
      if (!overlap(around.box, clamp.box, -whole * spacing)) errors.add(key, "must touch the body");
    }
    for (int j = 0; j < body.support_size(); ++j) {
      const std::string key = fmt::format("solid.body.{}.support.{}", i, j);
      const v1::Box& box = body.support(j).box();
      if (!overlap(around.box, box, -whole * spacing)) errors.add(key + ".box", "must touch the body");
      for (const int axis : body.support(j).along())
        if (axis >= c.dimension())
          errors.add(key + ".along", fmt::format("no \"{}\" in {} dimensions", "xyz"[axis], c.dimension()));
    }
  }
}

void check_times(const v1::Case& c, CaseErrors& errors) {
  const bool fixed = c.time().stepping() == v1::Time::fixed;
  if (fixed && !c.time().has_window()) errors.add("time.window", "missing, fixed windows need it");
  if (!c.time().has_window()) return;
  const double window = c.time().window();
  if (window > c.time().end())
    errors.add("time.window", fmt::format("{} must be <= time.end = {}", window, c.time().end()));
  if (c.output().frame_interval() < window)
    errors.add("output.frame_interval",
               fmt::format("{} must be >= time.window = {}", c.output().frame_interval(), window));
  if (!fixed) return;
  for (const auto& [key, value] : {std::pair{"time.end", c.time().end()},
                                   std::pair{"output.frame_interval", c.output().frame_interval()}})
    if (!divides(window, value))
      errors.add(key, fmt::format("{} must be a whole number of windows of {}", value, window));
}

}  // namespace

void check_rules(const v1::Case& c, CaseErrors& errors) {
  if (!c.has_fluid() && !c.has_solid()) errors.add("", "a case needs a [fluid], a [solid], or both");
  if (c.has_coupling() && !(c.has_fluid() && c.has_solid()))
    errors.add("coupling", "allowed only if the case has a [fluid] and a [solid]");
  if (!check_shapes(c, errors)) return;
  const auto scheme = c.coupling().scheme();
  const bool inertial = scheme == v1::Coupling::weak_inertial || scheme == v1::Coupling::strong_inertial;
  if (inertial && c.fluid().source() == v1::Fluid::deviation)
    errors.add("coupling.scheme",
               fmt::format(
                   "{} needs a source with the velocity divergence: fluid.source must be mixed or time_scale",
                   v1::Coupling::Scheme_Name(scheme)));
  check_scene(c, errors);
  if (c.has_fluid()) check_fluid(c, errors);
  if (c.has_fluid()) check_thickness(c.fluid(), errors);
  check_motions(c, errors);
  if (c.has_solid()) check_solid(c, errors);
  if (c.has_solid()) check_springs(c, errors);
  check_probes(c, errors);
  check_times(c, errors);
}

}  // namespace cosurge
