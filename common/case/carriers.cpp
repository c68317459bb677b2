#include "common/case/carriers.hpp"

#include <algorithm>
#include <optional>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

bool same(const v1::WallMotion& a, const v1::WallMotion& b) {
  return a.SerializeAsString() == b.SerializeAsString();
}

template <int dim>
Vec<dim> middle_of(const v1::Shape& clamp) {
  const Box<dim> bounds = from_case<dim>(clamp).bounds();
  return 0.5 * (bounds.min + bounds.max);
}

/// The number of the obstacle that the middle of a clamp lies in, or -1.
template <int dim>
int obstacle_at(const v1::Fluid& fluid, const v1::Shape& clamp) {
  const Vec<dim> middle = middle_of<dim>(clamp);
  for (int o = 0; o < fluid.obstacle_size(); ++o)
    if (from_case<dim>(fluid.obstacle(o).shape()).contains(middle)) return o;
  return -1;
}

/// The number of the body of another structure that the middle of a clamp lies in, or -1.
template <int dim>
int other_body_at(const v1::Case& the_case, const v1::Body& body, const v1::Shape& clamp) {
  const Vec<dim> middle = middle_of<dim>(clamp);
  for (int b = 0; b < the_case.solid().body_size(); ++b) {
    const v1::Body& other = the_case.solid().body(b);
    if (other.solid() != body.solid() && from_case<dim>(shape_of(other)).contains(middle)) return b;
  }
  return -1;
}

int other_body_at(const v1::Case& the_case, const v1::Body& body, const v1::Shape& clamp) {
  if (!body.has_solid()) return -1;
  return the_case.dimension() == 2 ? other_body_at<2>(the_case, body, clamp)
                                   : other_body_at<3>(the_case, body, clamp);
}

/// What holds a clamp: its name and its motion.
struct Holder {
  std::string name;
  v1::WallMotion motion;
};

Holder holder_of(const v1::Case& the_case, const v1::Body& body, const v1::Shape& clamp) {
  const v1::Fluid& fluid = the_case.fluid();
  if (const int b = other_body_at(the_case, body, clamp); b >= 0) {
    const v1::Body& other = the_case.solid().body(b);
    const std::string name = fmt::format("solid.body.{}", b);
    require(solid_of(the_case, other).model() == v1::SolidModel::rigid,
            "its clamps lie in {}, whose motion is computed; clamps follow the tank, obstacles and bodies of "
            "the model rigid",
            name);
    require(other.has_motion() || other.clamp().empty(),
            "its clamps lie in {}, which has clamps and no motion of its own; give both bodies a motion",
            name);
    return {.name = name, .motion = other.has_motion() ? other.motion() : fluid.tank_motion()};
  }
  const int o = the_case.dimension() == 2 ? obstacle_at<2>(fluid, clamp) : obstacle_at<3>(fluid, clamp);
  if (o < 0) return {.name = "the tank", .motion = fluid.tank_motion()};
  return {.name = fmt::format("fluid.obstacle.{}", o), .motion = motion_of(fluid, fluid.obstacle(o))};
}

}  // namespace

bool moves(const v1::WallMotion& motion) { return motion.row_size() > 0 || motion.frequency() > 0; }

const v1::WallMotion& motion_of(const v1::Fluid& fluid, const v1::Obstacle& obstacle) {
  return obstacle.has_motion() ? obstacle.motion() : fluid.tank_motion();
}

bool is_held(const v1::Solid& solid, const v1::Body& body) {
  return body.clamp_size() > 0 || body.support_size() > 0 || solid.model() == v1::SolidModel::rigid ||
         solid.model() == v1::SolidModel::sprung;
}

bool is_held_at_rest(const v1::Case& the_case, const v1::Body& body) {
  const v1::Solid& solid = solid_of(the_case, body);
  if (!is_held(solid, body) || solid.model() == v1::SolidModel::sprung) return false;
  return same(motion_of(the_case, body), the_case.fluid().tank_motion());
}

bool is_held_by_another(const v1::Case& the_case, const v1::Body& body) {
  const auto in_another = [&](const v1::Shape& clamp) { return other_body_at(the_case, body, clamp) >= 0; };
  return !body.has_motion() && std::any_of(body.clamp().begin(), body.clamp().end(), in_another);
}

v1::WallMotion motion_of(const v1::Case& the_case, const v1::Body& body) {
  if (!is_held(solid_of(the_case, body), body)) return {};
  if (body.has_motion()) return body.motion();
  std::optional<Holder> first;
  for (const v1::Shape& clamp : body.clamp()) {
    const Holder holder = holder_of(the_case, body, clamp);
    if (!first) first = holder;
    require(same(first->motion, holder.motion),
            "its clamps lie in {} and in {}, which move differently; give the body a motion of its own",
            first->name, holder.name);
  }
  return first ? first->motion : the_case.fluid().tank_motion();
}

}  // namespace cosurge
