#include "common/case/case_doubts.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/motion_doubts.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

/// Usual ranges of values in SI units.
struct Usual {
  double least, most;
};
constexpr Usual gravity_of_planets = {1, 30};       // m/s2; none is usual, too
constexpr Usual length_of_a_tank = {0.01, 500};     // m
constexpr Usual density_of_liquids = {400, 14000};  // kg/m3: methane, mercury
constexpr Usual density_of_solids = {5, 23000};     // kg/m3: foam, osmium
constexpr Usual modulus_of_solids = {1e3, 1.3e12};  // Pa: gel, diamond

class Doubts {
 public:
  void number(const std::string& key, double value, const Usual& usual, const std::string& unit) {
    if (value >= usual.least && value <= usual.most) return;
    all.push_back(fmt::format("{}: {:.4g} {} is outside the usual range {:g} to {:g} {}; check the units",
                              key, value, unit, usual.least, usual.most, unit));
  }
  void solid(const std::string& key, const v1::Solid& solid) {
    number(key + ".density", solid.density(), density_of_solids, "kg/m3");
    if (solid.has_young_modulus())
      number(key + ".young_modulus", solid.young_modulus(), modulus_of_solids, "Pa");
  }
  std::vector<std::string> all;
};

void check_gravity(const v1::Case& c, Doubts& doubts) {
  double square = 0;
  for (const double g : c.gravity()) square += g * g;
  if (square == 0) return;
  doubts.number("gravity", std::sqrt(square), gravity_of_planets, "m/s2");
  if (const double up = c.gravity(c.gravity_size() - 1); c.has_fluid() && up > 0)
    doubts.all.push_back(fmt::format(
        "gravity: {:g} m/s2 along {} points out of the open top of the tank; downwards is negative", up,
        c.dimension() == 2 ? "y" : "z"));
}

}  // namespace

std::vector<std::string> doubts(const v1::Case& c) {
  Doubts doubts;
  check_gravity(c, doubts);
  if (c.has_fluid()) {
    double longest = 0;
    for (int k = 0; k < c.dimension(); ++k)
      longest = std::max(longest, c.fluid().tank().max(k) - c.fluid().tank().min(k));
    doubts.number("fluid.tank", longest, length_of_a_tank, "m");
    doubts.number("fluid.density", c.fluid().density(), density_of_liquids, "kg/m3");
  }
  if (c.has_solid() && !has_several_solids(c)) doubts.solid("solid", c.solid());
  for (int k = 0; k < c.solids_size(); ++k) doubts.solid(fmt::format("solid.{}", k), c.solids(k));
  for (const std::string& doubt : motion_doubts(c)) doubts.all.push_back(with_written_keys(c, doubt));
  return doubts.all;
}

}  // namespace cosurge
