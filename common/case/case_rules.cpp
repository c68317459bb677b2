#include "common/case/case_rules.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "common/case/bodies.hpp"
#include "common/case/lattice_rules.hpp"
#include "common/case/motion_rules.hpp"
#include "common/case/outline_rules.hpp"
#include "common/case/probe_rules.hpp"
#include "common/case/region_rules.hpp"
#include "common/case/several_solids.hpp"
#include "common/case/spring_rules.hpp"
#include "common/error.hpp"
#include "common/geometry/shape.hpp"

namespace cosurge {
namespace {

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

/// Boxes on the lattice; water and bodies in the tank and apart from each other. `all`: of a case with all
/// its bodies, not of one of several structures, whose clamps may lie in another.
void check_scene(const v1::Case& c, bool all, CaseErrors& errors) {
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
    const double margin = whole_spacings * c.fluid().spacing();
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
  if (!all) return;
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

/// Obstacles must be so thick that the water on one side does not interact with the water on the other side.
void check_thickness(const v1::Fluid& fluid, CaseErrors& errors) {
  const double layers = std::ceil(fluid.re_laplacian());
  for (const NamedBox& named : obstacle_boxes(fluid))
    for (int k = 0; k < named.box.min_size(); ++k)
      if (const double side = named.box.max(k) - named.box.min(k);
          side < (layers - whole_spacings) * fluid.spacing())
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
  const bool by_elements = solid.model() == v1::SolidModel::fem || solid.model() == v1::SolidModel::auto_;
  if (solid.material() == v1::Solid::neo_hookean && !by_elements && deformable)
    errors.add("solid.material",
               fmt::format("neo_hookean is available for the models fem and auto only, not for {}",
                           v1::SolidModel::Word_Name(solid.model())));
  // Layers that keep the water on one side from interacting with the water on the other side.
  const double fewest = std::max(3.0, c.has_fluid() ? std::ceil(c.fluid().re_laplacian()) - 1 : 0.0);
  const std::vector<NamedBox> bounds = body_bounds(solid, c.dimension());
  for (int i = 0; i < solid.body_size(); ++i) {
    const v1::Body& body = solid.body(i);
    const NamedBox& around = bounds[static_cast<std::size_t>(i)];
    for (int k = 0; k < around.box.min_size(); ++k) {
      const double side = around.box.max(k) - around.box.min(k);
      if (side < (fewest - whole_spacings) * fluid_spacing)
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
      if (!overlap(around.box, clamp.box, -whole_spacings * spacing)) errors.add(key, "must touch the body");
    }
    for (int j = 0; j < body.support_size(); ++j) {
      const std::string key = fmt::format("solid.body.{}.support.{}", i, j);
      const v1::Box& box = body.support(j).box();
      if (!overlap(around.box, box, -whole_spacings * spacing))
        errors.add(key + ".box", "must touch the body");
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

/// Names of several structures.
void check_names(const v1::Case& c, CaseErrors& errors) {
  if (!c.has_fluid())
    errors.add("solid", "several [[solid]] need a [fluid]: without water, run a case for each");
  std::set<std::string> taken = {"fluid", "solid", "coupling"};
  for (int k = 0; k < c.solids_size(); ++k) {
    const std::string key = fmt::format("solid.{}.name", k), &name = c.solids(k).name();
    const bool plain = std::all_of(name.begin(), name.end(), [](char a) {
      return std::isalnum(static_cast<unsigned char>(a)) != 0 || a == '_';
    });
    if (name.empty())
      errors.add(key, "missing, several [[solid]] need names");
    else if (!plain)
      errors.add(key, "must consist of letters, digits and _");
    else if (!taken.insert(name).second)
      errors.add(key, fmt::format("\"{}\" is taken", name));
  }
}

/// Materials, models and lattices, of each structure by itself.
void check_solids(const v1::Case& c, CaseErrors& errors) {
  if (!has_several_solids(c)) {
    check_solid(c, errors);
    return check_springs(c, errors);
  }
  const auto of_all = errors.written;
  for (int k = 0; k < c.solids_size(); ++k) {
    errors.written = [k](const std::string& text) { return with_written_keys(k, text); };
    const v1::Case one = case_of_solid(c, k);
    check_scene(one, false, errors);
    check_solid(one, errors);
    check_springs(one, errors);
  }
  errors.written = of_all;
}

}  // namespace

void check_rules(const v1::Case& c, CaseErrors& errors) {
  if (has_several_solids(c)) {
    errors.written = [&c](const std::string& text) { return with_written_keys(c, text); };
    check_names(c, errors);
  }
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
  check_scene(c, true, errors);
  if (c.has_fluid()) check_fluid(c, errors);
  if (c.has_fluid()) check_thickness(c.fluid(), errors);
  const std::size_t before = errors.lines.size();
  check_motions(c, errors);
  const bool motions = errors.lines.size() == before;
  if (c.has_solid() && (motions || !has_several_solids(c))) check_solids(c, errors);
  check_probes(c, errors);
  check_times(c, errors);
}

}  // namespace cosurge
