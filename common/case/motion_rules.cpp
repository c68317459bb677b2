#include "common/case/motion_rules.hpp"

#include <algorithm>

#include "common/case/carriers.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

void check_motion(const std::string& key, const v1::WallMotion& motion, CaseErrors& errors) {
  const bool formula = motion.amplitude_size() > 0 || motion.angle() != 0;
  if (formula && motion.has_table()) errors.add(key, "must have either amplitude and angle, or a table");
  if (formula && motion.frequency() <= 0)
    errors.add(key + ".frequency", "must be > 0 [Hz] if there is an amplitude");
}

/// An initial velocity needs a body that can have it.
void check_velocity(const v1::Solid& solid, const v1::Body& body, const std::string& key,
                    CaseErrors& errors) {
  if (body.velocity_size() == 0) return;
  if (solid.model() != v1::SolidModel::sprung) {
    if (is_held(solid, body))
      errors.add(key + ".velocity",
                 "is the initial velocity of a free body, but this body is held: it starts with the velocity "
                 "of what holds it (solid.body.motion)");
    return;
  }
  for (int axis = 0; axis < body.velocity_size(); ++axis) {
    const auto along = [&](const v1::Spring& spring) { return spring.motion() == v1::Spring::x + axis; };
    const auto& springs = solid.sprung().spring();
    if (body.velocity(axis) != 0 && std::none_of(springs.begin(), springs.end(), along))
      errors.add(key + ".velocity",
                 fmt::format("has {} m/s along {}, but the body is fixed along {}: add a solid.sprung.spring "
                             "with motion = \"{}\" (stiffness 0: free)",
                             body.velocity(axis), "xyz"[axis], "xyz"[axis], "xyz"[axis]));
  }
}

void check_body(const v1::Case& c, int i, CaseErrors& errors) {
  const v1::Body& body = c.solid().body(i);
  const std::string key = fmt::format("solid.body.{}", i);
  if (body.has_motion()) {
    check_motion(key + ".motion", body.motion(), errors);
    if (!is_held(solid_of(c, body), body))
      errors.add(key + ".motion",
                 "is the motion of what holds the body, but nothing holds it: add a clamp or a support");
  }
  check_velocity(solid_of(c, body), body, key, errors);
  try {
    static_cast<void>(motion_of(c, body));
  } catch (const Error& error) {
    errors.add(key + ".clamp", error.what());
  }
}

}  // namespace

void check_motions(const v1::Case& c, CaseErrors& errors) {
  check_motion("fluid.tank_motion", c.fluid().tank_motion(), errors);
  for (int i = 0; i < c.fluid().obstacle_size(); ++i)
    check_motion(fmt::format("fluid.obstacle.{}.motion", i), c.fluid().obstacle(i).motion(), errors);
  for (int i = 0; i < c.solid().body_size(); ++i) check_body(c, i, errors);
}

}  // namespace cosurge
