#include "common/case/region_rules.hpp"

#include <algorithm>
#include <functional>

#include "common/case/bodies.hpp"
#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/case/outline_rules.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr double most_sites = 1e8;  // no memory holds more
constexpr double most_tanks = 20;  // an obstacle that is so many times longer than the tank is in other units
constexpr double millimetre = 0.001;

/// A shape of the case and where it stands there.
struct Region {
  std::string key;
  v1::Shape shape;
  bool moves = false;
};

std::vector<Region> waters(const v1::Fluid& fluid) {
  std::vector<Region> regions;
  for (int i = 0; i < fluid.water_size(); ++i)
    regions.push_back({.key = fmt::format("fluid.water.{}", i), .shape = fluid.water(i)});
  return regions;
}

std::vector<Region> obstacles(const v1::Fluid& fluid) {
  std::vector<Region> regions;
  for (int i = 0; i < fluid.obstacle_size(); ++i)
    regions.push_back({.key = fmt::format("fluid.obstacle.{}.shape", i),
                       .shape = fluid.obstacle(i).shape(),
                       .moves = moves(fluid.obstacle(i).motion())});
  return regions;
}

std::vector<Region> bodies(const v1::Solid& solid) {
  std::vector<Region> regions;
  for (int i = 0; i < solid.body_size(); ++i)
    regions.push_back({.key = body_key(solid, i), .shape = shape_of(solid.body(i))});
  return regions;
}

template <int dim>
std::string text(const Vec<dim>& x) {
  std::vector<std::string> numbers;
  for (const double value : x) numbers.push_back(fmt::format("{:.6g}", value));
  return fmt::format("({})", fmt::join(numbers, ", "));
}

template <int dim>
std::string extent_of(const Box<dim>& box) {
  return fmt::format("it reaches from {} to {} m", text<dim>(box.min), text<dim>(box.max));
}

/// Sites of the lattice in and around a box.
template <int dim>
double sites_in(const Box<dim>& box, double spacing) {
  return ((box.max - box.min) / spacing + Vec<dim>::Constant(2)).prod();
}

/// Possible cause of an outline with large coordinates.
const char* unit_remedy(const v1::Shape& shape) {
  return shape.vertex_size() > 0 && !shape.has_scale() ? "; if its file is in mm, set scale = 0.001" : "";
}

template <int dim>
bool region_fits(const Region& region, const std::string& spacing_key, double spacing, CaseErrors& errors) {
  const Box<dim> bounds = from_case<dim>(region.shape).bounds();
  const double sites = sites_in(bounds, spacing);
  if (sites < most_sites) return true;
  errors.add(region.key,
             fmt::format("has {:.3g} sites around it with {} = {} m, must be < {:.0e}: {}{}", sites,
                         spacing_key, spacing, most_sites, extent_of(bounds), unit_remedy(region.shape)));
  return false;
}

template <int dim>
bool sizes_fit(const v1::Case& c, CaseErrors& errors) {
  bool fit = true;
  if (c.has_fluid()) {
    const double spacing = c.fluid().spacing();
    const auto tank = from_case<dim>(c.fluid().tank());
    const Vec<dim> walls = Vec<dim>::Constant(std::ceil(c.fluid().re_laplacian()) * spacing);
    const double sites = sites_in(Box<dim>(tank.min - walls, tank.max + walls), spacing);
    if (!(sites < most_sites)) {
      errors.add("fluid.tank",
                 fmt::format("has {:.3g} sites with fluid.spacing = {} m, must be < {:.0e}: make "
                             "the tank smaller or the spacing larger",
                             sites, spacing, most_sites));
      fit = false;
    }
    for (const auto& regions : {waters(c.fluid()), obstacles(c.fluid()), bodies(c.solid())})
      for (const Region& region : regions)
        fit = region_fits<dim>(region, "fluid.spacing", spacing, errors) && fit;
  }
  if (c.solid().has_spacing())
    for (const Region& region : bodies(c.solid()))
      fit = region_fits<dim>(region, "solid.spacing", c.solid().spacing(), errors) && fit;
  return fit;
}

/// Whether a site of the shape is as wanted; each is looked at only until one is.
template <int dim>
bool has_site(const Shape<dim>& shape, double spacing, const std::function<bool(const Vec<dim>&)>& wanted) {
  using Index = Eigen::Matrix<long, dim, 1>;
  const Index lower = (shape.bounds().min / spacing).array().floor().template cast<long>();
  const Index upper = (shape.bounds().max / spacing).array().ceil().template cast<long>();
  Index k = lower;
  while (k[dim - 1] <= upper[dim - 1]) {
    const Vec<dim> x = site<dim>(k, spacing);
    if (wanted(x) && shape.contains(x)) return true;
    int axis = 0;
    while (axis < dim - 1 && ++k[axis] > upper[axis]) {
      k[axis] = lower[axis];
      ++axis;
    }
    if (axis == dim - 1) ++k[axis];
  }
  return false;
}

/// Whether a box lies beside or below the tank; above it too where `above` counts.
template <int dim>
bool outside(const Box<dim>& box, const Box<dim>& tank, bool above) {
  for (int axis = 0; axis < dim; ++axis) {
    if (box.max[axis] <= tank.min[axis]) return true;
    if (box.min[axis] >= tank.max[axis] && (above || axis < dim - 1)) return true;
  }
  return false;
}

template <int dim>
bool in_the_tank(const Region& region, const Box<dim>& tank, CaseErrors& errors) {
  const Box<dim> bounds = from_case<dim>(region.shape).bounds();
  const double longest = (tank.max - tank.min).maxCoeff();
  if ((bounds.max - bounds.min).maxCoeff() > most_tanks * longest) {
    errors.add(region.key, fmt::format("is more than {} times as long as fluid.tank: {}{}", most_tanks,
                                       extent_of(bounds), unit_remedy(region.shape)));
    return false;
  }
  if (region.moves || !outside(bounds, tank, true)) return true;
  const Box<dim> in_mm(millimetre * bounds.min, millimetre * bounds.max);
  errors.add(region.key, fmt::format("lies outside fluid.tank: {}{}", extent_of(bounds),
                                     outside(in_mm, tank, true) ? "" : unit_remedy(region.shape)));
  return false;
}

template <int dim>
void check_water(const v1::Case& c, CaseErrors& errors) {
  const double spacing = c.fluid().spacing();
  const auto tank = from_case<dim>(c.fluid().tank());
  std::vector<Shape<dim>> taken;
  for (const auto& regions : {obstacles(c.fluid()), bodies(c.solid())})
    for (const Region& region : regions) taken.push_back(from_case<dim>(region.shape));
  for (const Region& region : waters(c.fluid())) {
    if (!in_the_tank(region, tank, errors)) continue;
    const auto free = [&](const Vec<dim>& x) {
      return tank.contains(x) && std::none_of(taken.begin(), taken.end(),
                                              [&](const Shape<dim>& shape) { return shape.contains(x); });
    };
    if (!has_site<dim>(from_case<dim>(region.shape), spacing, free))
      errors.add(region.key, fmt::format("contains no water particle with a spacing of {} m: it is too thin, "
                                         "or obstacles and bodies fill all of it",
                                         spacing));
  }
}

template <int dim>
void check_obstacle_sites(const v1::Fluid& fluid, CaseErrors& errors) {
  const auto tank = from_case<dim>(fluid.tank());
  for (const Region& region : obstacles(fluid)) {
    if (!in_the_tank(region, tank, errors)) continue;
    const auto counts = [&](const Vec<dim>& x) {
      return region.moves || !outside(Box<dim>(x, x), tank, false);
    };
    if (!has_site<dim>(from_case<dim>(region.shape), fluid.spacing(), counts))
      errors.add(region.key, fmt::format("contains no particle with a spacing of {} m: it is too thin; make "
                                         "it thicker or the spacing smaller",
                                         fluid.spacing()));
  }
}

/// Water must not flow through the region of a clamp.
template <int dim>
void check_clamps(const v1::Case& c, CaseErrors& errors) {
  const auto tank = from_case<dim>(c.fluid().tank());
  std::vector<Shape<dim>> solid;
  for (const auto& regions : {obstacles(c.fluid()), bodies(c.solid())})
    for (const Region& region : regions) solid.push_back(from_case<dim>(region.shape));
  for (int i = 0; i < c.solid().body_size(); ++i) {
    for (int j = 0; j < c.solid().body(i).clamp_size(); ++j) {
      const Region clamp{.key = fmt::format("solid.body.{}.clamp.{}", i, j),
                         .shape = c.solid().body(i).clamp(j)};
      if (!region_fits<dim>(clamp, "fluid.spacing", c.fluid().spacing(), errors)) continue;
      const auto open = [&](const Vec<dim>& x) {
        return tank.contains(x) && std::none_of(solid.begin(), solid.end(),
                                                [&](const Shape<dim>& shape) { return shape.contains(x); });
      };
      if (has_site<dim>(from_case<dim>(clamp.shape), c.fluid().spacing(), open))
        errors.add(clamp.key,
                   "lies in fluid.tank, where water would flow through it: put a fluid.obstacle of the "
                   "same shape there, or move it out of the tank");
    }
  }
}

}  // namespace

bool check_sizes(const v1::Case& c, CaseErrors& errors) {
  return c.dimension() == 2 ? sizes_fit<2>(c, errors) : sizes_fit<3>(c, errors);
}

void check_filled(const v1::Case& c, CaseErrors& errors) {
  if (!c.has_fluid()) return;
  if (c.dimension() == 2) {
    check_water<2>(c, errors);
    check_obstacle_sites<2>(c.fluid(), errors);
    check_clamps<2>(c, errors);
  } else {
    check_water<3>(c, errors);
    check_obstacle_sites<3>(c.fluid(), errors);
    check_clamps<3>(c, errors);
  }
}

}  // namespace cosurge
