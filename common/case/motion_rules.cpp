#include "common/case/motion_rules.hpp"

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

void check_body(const v1::Case& c, int i, CaseErrors& errors) {
  const v1::Body& body = c.solid().body(i);
  const std::string key = fmt::format("solid.body.{}", i);
  if (body.has_motion()) {
    check_motion(key + ".motion", body.motion(), errors);
    if (!is_held(solid_of(c, body), body))
      errors.add(key + ".motion",
                 "is the motion of what holds the body, but nothing holds it: add a clamp or a support");
  }
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
