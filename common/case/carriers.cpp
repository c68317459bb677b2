#include "common/case/carriers.hpp"

#include <vector>

#include "common/case/from_case.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

bool same(const v1::WallMotion& a, const v1::WallMotion& b) {
  return a.SerializeAsString() == b.SerializeAsString();
}

/// The number of the obstacle that the middle of a clamp lies in, or -1.
template <int dim>
int obstacle_at(const v1::Fluid& fluid, const v1::Shape& clamp) {
  const Box<dim> bounds = from_case<dim>(clamp).bounds();
  const Vec<dim> middle = 0.5 * (bounds.min + bounds.max);
  for (int o = 0; o < fluid.obstacle_size(); ++o)
    if (from_case<dim>(fluid.obstacle(o).shape()).contains(middle)) return o;
  return -1;
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
  const v1::Solid& solid = the_case.solid();
  if (!is_held(solid, body) || solid.model() == v1::SolidModel::sprung) return false;
  return same(motion_of(the_case, body), the_case.fluid().tank_motion());
}

v1::WallMotion motion_of(const v1::Case& the_case, const v1::Body& body) {
  if (!is_held(the_case.solid(), body)) return {};
  if (body.has_motion()) return body.motion();
  const v1::Fluid& fluid = the_case.fluid();
  const auto name = [](int o) { return o < 0 ? "the tank" : fmt::format("fluid.obstacle.{}", o); };
  const v1::WallMotion* found = nullptr;
  int first = -1;
  for (const v1::Shape& clamp : body.clamp()) {
    const int o = the_case.dimension() == 2 ? obstacle_at<2>(fluid, clamp) : obstacle_at<3>(fluid, clamp);
    const v1::WallMotion& motion = o < 0 ? fluid.tank_motion() : motion_of(fluid, fluid.obstacle(o));
    if (found == nullptr) first = o;
    require(found == nullptr || same(*found, motion),
            "its clamps lie in {} and in {}, which move differently; give the body a motion of its own",
            name(first), name(o));
    found = &motion;
  }
  return found != nullptr ? *found : fluid.tank_motion();
}

}  // namespace cosurge
