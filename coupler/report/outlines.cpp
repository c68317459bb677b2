#include "coupler/report/outlines.hpp"

#include <fmt/ranges.h>

#include <set>

#include "common/case/bodies.hpp"
#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/geometry/body_sites.hpp"
#include "coupler/report/shape_lines.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;

/// "obstacle 1", or "obstacle" where there is one only.
std::string numbered(const std::string& name, int k, int all) {
  return all > 1 ? fmt::format("{} {}", name, k) : name;
}

template <int dim>
Json poses(const Motion<dim>& motion, const std::vector<double>& times) {
  Json all = Json::array();
  for (const double t : times) {
    const Vec<dim> origin = motion.place(Vec<dim>::Zero(), t);
    const Mat<dim> turned = motion.turned(t);
    std::vector<double> pose(origin.data(), origin.data() + dim);
    pose.insert(pose.end(), turned.data(), turned.data() + dim * dim);  // column by column: the axes
    all.push_back(pose);
  }
  return all;
}

template <int dim>
Json part(const std::string& kind, const std::string& label, const std::vector<Polyline<dim>>& lines) {
  return {{"kind", kind}, {"label", label}, {"lines", json_of<dim>(lines)}};
}

template <int dim>
Json moving_part(const std::string& kind, const std::string& label, const std::vector<Polyline<dim>>& lines,
                 const v1::WallMotion& wall_motion, const std::vector<double>& times) {
  Json out = part<dim>(kind, label, lines);
  const auto motion = from_case<dim>(wall_motion);
  if (motion.moves()) out["poses"] = poses(motion, times);
  return out;
}

template <int dim>
void add_fluid(Json& out, const v1::Fluid& fluid, const std::vector<double>& times) {
  out.push_back(
      moving_part<dim>("tank", "tank", tank_edges(from_case<dim>(fluid.tank())), fluid.tank_motion(), times));
  for (int k = 0; k < fluid.water_size(); ++k)
    out.push_back(part<dim>("water", numbered("water", k, fluid.water_size()) + " at t = 0",
                            edges_of(from_case<dim>(fluid.water(k)))));
  for (int k = 0; k < fluid.obstacle_size(); ++k)
    out.push_back(moving_part<dim>("obstacle", numbered("obstacle", k, fluid.obstacle_size()),
                                   edges_of(from_case<dim>(fluid.obstacle(k).shape())),
                                   motion_of(fluid, fluid.obstacle(k)), times));
}

std::string axes_of(const v1::Support& support) {
  std::vector<std::string> axes;
  for (const int axis : support.along())
    axes.push_back(v1::Axis::Word_Name(static_cast<v1::Axis::Word>(axis)));
  return axes.empty() ? "all axes" : fmt::format("{}", fmt::join(axes, ", "));
}

template <int dim>
void add_solid(Json& out, const v1::Solid& solid) {
  for (int b = 0; b < solid.body_size(); ++b) {
    const v1::Body& body = solid.body(b);
    const std::string name = numbered("body", b, solid.body_size());
    out.push_back(part<dim>("body", name + " at t = 0", edges_of(from_case<dim>(shape_of(body)))));
    for (const v1::Shape& clamp : body.clamp())
      out.push_back(part<dim>("clamp", "clamp of " + name, edges_of(from_case<dim>(clamp))));
    for (const v1::Support& support : body.support())
      out.push_back(part<dim>("support", fmt::format("support of {} ({})", name, axes_of(support)),
                              edges_of(from_case<dim>(support.box()))));
  }
}

template <int dim>
Json all_parts(const v1::Case& the_case, const std::vector<double>& times) {
  Json out = Json::array();
  if (the_case.has_fluid()) add_fluid<dim>(out, the_case.fluid(), times);
  if (the_case.has_solid()) add_solid<dim>(out, the_case.solid());
  for (const v1::Probe& probe : the_case.output().probe()) {
    const Vec<dim> place = from_case<dim>(probe.position());
    out.push_back(part<dim>("probe", probe.name(), {{place}}));
  }
  return out;
}

/// Times at which a motion takes the corners of a box farthest along an axis.
template <int dim>
std::set<double> extreme_times(const Motion<dim>& motion, const Box<dim>& box, double end) {
  constexpr int samples = 2000;
  std::set<double> times;
  for (int axis = 0; axis < dim; ++axis) {
    double least = box.max[axis], most = box.max[axis], at_least = 0, at_most = 0;
    for (int k = 1; k <= samples; ++k) {
      const double t = end * k / samples;
      const double x = motion.place(box.max, t)[axis];
      if (x < least) least = x, at_least = t;
      if (x > most) most = x, at_most = t;
    }
    for (const double t : {at_least, at_most})
      if (t > 0) times.insert(t);
  }
  return times;
}

template <int dim>
void add_motion(Json& out, const std::string& name, const std::vector<Polyline<dim>>& lines,
                const Box<dim>& box, const v1::WallMotion& wall_motion, double end) {
  const auto motion = from_case<dim>(wall_motion);
  if (!motion.moves()) return;
  for (const double t : extreme_times(motion, box, end)) {
    std::vector<Polyline<dim>> there = lines;
    for (Polyline<dim>& line : there)
      for (Vec<dim>& x : line) x = motion.place(x, t);
    out.push_back(part<dim>("extreme", fmt::format("{} at t = {:.4g} s", name, t), there));
  }
  constexpr int points = 400;
  Polyline<dim> path;
  for (int k = 0; k <= points; ++k)
    path.push_back(motion.place(Vec<dim>(0.5 * (box.min + box.max)), end * k / points));
  out.push_back(part<dim>("path", "path of the middle of " + name, {path}));
}

template <int dim>
Json parts_of_check(const v1::Case& the_case) {
  Json out = all_parts<dim>(the_case, {0.0});
  const double end = the_case.time().end();
  if (the_case.has_fluid()) {
    const v1::Fluid& fluid = the_case.fluid();
    const auto tank = from_case<dim>(fluid.tank());
    add_motion<dim>(out, "tank", tank_edges(tank), tank, fluid.tank_motion(), end);
    for (int k = 0; k < fluid.obstacle_size(); ++k) {
      const auto shape = from_case<dim>(fluid.obstacle(k).shape());
      add_motion<dim>(out, numbered("obstacle", k, fluid.obstacle_size()), edges_of(shape), shape.bounds(),
                      motion_of(fluid, fluid.obstacle(k)), end);
    }
  }
  if constexpr (dim == 2) {
    const v1::Solid& solid = the_case.solid();
    for (int b = 0; b < solid.body_size(); ++b) {
      const auto shape = from_case<2>(shape_of(solid.body(b)));
      if (shape.is_box()) continue;
      const BodySites<2> sites(shape, solid_spacing(the_case));
      out.push_back(part<2>("stairs", numbered("body", b, solid.body_size()) + " on the lattice",
                            stairs_of(sites.all(), solid_spacing(the_case))));
    }
  }
  return out;
}

}  // namespace

Json outlines(const v1::Case& the_case, const std::vector<double>& times) {
  return the_case.dimension() == 2 ? all_parts<2>(the_case, times) : all_parts<3>(the_case, times);
}

Json outlines_of_check(const v1::Case& the_case) {
  return the_case.dimension() == 2 ? parts_of_check<2>(the_case) : parts_of_check<3>(the_case);
}

}  // namespace cosurge
