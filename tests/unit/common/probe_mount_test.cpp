#include "common/case/probe_mount.hpp"

#include <gtest/gtest.h>

#include "tests/support/outlines.hpp"

namespace cosurge {
namespace {

using On = ProbeMount::On;

/// A tank of 1 x 1 m on a lattice of 0.1 m, with an obstacle and a body.
v1::Case scene() {
  v1::Case c;
  c.set_dimension(2);
  c.mutable_fluid()->set_spacing(0.1);
  v1::Box& tank = *c.mutable_fluid()->mutable_tank();
  for (const double value : {0.0, 0.0}) tank.add_min(value);
  for (const double value : {1.0, 1.0}) tank.add_max(value);
  *c.mutable_fluid()->add_obstacle()->mutable_shape() = test::box({0.2, 0}, {0.4, 0.3});
  *c.mutable_solid()->add_body()->mutable_shape() = test::box({0.6, 0}, {0.8, 0.5});
  return c;
}

ProbeMount mount(const std::vector<double>& x) {
  v1::Probe probe;
  probe.mutable_position()->Assign(x.begin(), x.end());
  return mount_of(scene(), probe);
}

TEST(ProbeMount, IsTheBodyOrObstacleInOrOnWhichAProbeLies) {
  EXPECT_EQ(mount({0.7, 0.2}).on, On::body);
  EXPECT_EQ(mount({0.6, 0.2}).on, On::body);
  EXPECT_EQ(mount({0.6, 0.0}).on, On::body);
  EXPECT_EQ(mount({0.3, 0.2}).on, On::obstacle);
  EXPECT_EQ(mount({0.4005, 0.2}).on, On::obstacle);
  EXPECT_EQ(mount({0.3, 0.2}).number, 0);
  EXPECT_EQ(mount({0.402, 0.2}).on, On::tank);
}

TEST(ProbeMount, IsTheSideOfTheTankOnWhichAProbeLiesAndInCornersTheFloor) {
  for (const auto& [x, axis, upper] : std::vector<std::tuple<std::vector<double>, int, bool>>{
           {{0.0, 0.5}, 0, false}, {{1.0, 0.5}, 0, true}, {{0.5, 0.0}, 1, false}, {{0.0, 0.0}, 1, false}}) {
    const ProbeMount on = mount(x);
    EXPECT_EQ(on.on, On::face);
    EXPECT_EQ(on.axis, axis);
    EXPECT_EQ(on.upper, upper);
  }
  EXPECT_EQ(mount({0.5, 0.5}).on, On::tank);
  EXPECT_EQ(mount({0.5, 1.0}).on, On::tank);  // it is open at the top
}

}  // namespace
}  // namespace cosurge
