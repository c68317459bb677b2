#include "common/case/motion_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "common/case/carriers.hpp"
#include "common/case/from_case.hpp"
#include "common/case/movers.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr double most_falls = 10;  // limit of the wall speed [speed of a fall through the tank]
constexpr int samples = 1000;      // number of times checked in a run
constexpr double deep = 0.75;      // [spacings]; wall particles lie half a spacing inside

/// A table that has no row between the start and the end moves nothing.
std::string without_rows(const std::string& key, const v1::WallMotion& motion, int dimension, double end) {
  if (motion.row().empty()) return "";
  const double first = motion.row(0), last = motion.row(motion.row_size() - dimension - 2);
  if (last <= 0)
    return fmt::format("{}: the table ends at {:.6g} s, before the run starts at 0 s: nothing moves", key,
                       last);
  if (first >= end)
    return fmt::format("{}: the table starts at {:.6g} s, after the run ends at {:.6g} s: nothing moves", key,
                       first, end);
  return "";
}

/// Instants of the run, and those of the table's rows in it with the middles between them.
std::vector<double> instants(const v1::WallMotion& motion, int dimension, double end) {
  std::vector<double> all;
  for (int k = 0; k <= samples; ++k) all.push_back(end * k / samples);
  for (int r = 0; r + dimension + 1 < motion.row_size(); r += dimension + 2) {
    all.push_back(motion.row(r));
    if (r > 0) all.push_back(0.5 * (motion.row(r) + motion.row(r - dimension - 2)));
  }
  std::erase_if(all, [&](double t) { return t < 0 || t > end; });
  std::sort(all.begin(), all.end());
  return all;
}

template <int dim>
std::string too_fast(const v1::Case& c, const Mover<dim>& mover, const std::vector<double>& times) {
  if (c.gravity_size() == 0) return "";
  const Eigen::Map<const Vec<dim>> gravity(c.gravity().data());
  const Box<dim> scene = c.has_fluid() ? from_case<dim>(c.fluid().tank()) : mover.box;
  const double fall = std::sqrt(2 * gravity.norm() * (scene.max - scene.min).maxCoeff());
  double fastest = 0, when = 0;
  for (const double t : times)
    if (const double speed = mover.speed(t); speed > fastest) {
      fastest = speed;
      when = t;
    }
  if (fall == 0 || fastest <= most_falls * fall) return "";
  return fmt::format(
      "{}: moves at {:.3g} m/s at t = {:.4g} s, {:.0f} times the speed of a fall through the tank ({:.3g} "
      "m/s): lengths are in m, times in s, angles of a formula in rad",
      mover.key, fastest, when, fastest / fall, fall);
}

/// Where the box of an obstacle with a motion of its own comes deeper into the tank's walls than it is drawn.
template <int dim>
std::string into_the_tank(const v1::Case& c, const Mover<dim>& mover, const std::vector<double>& times) {
  if (!mover.key.starts_with("fluid.obstacle")) return "";
  const auto tank = from_case<dim>(c.fluid().tank());
  const auto tank_motion = from_case<dim>(c.fluid().tank_motion());
  const auto depth = [&](const Vec<dim>& X, double t, int wall) {
    const Vec<dim> placed = mover.motion.place(X, t);
    const Vec<dim> x = tank_motion.moves() ? tank_motion.origin(placed, t) : placed;
    if (x[dim - 1] >= tank.max[dim - 1]) return 0.0;  // above the open top
    return wall < dim ? tank.min[wall] - x[wall] : x[wall - dim] - tank.max[wall - dim];
  };
  for (const double t : times)
    for (const Vec<dim>& X : corners_of(mover.box))
      for (int wall = 0; wall < 2 * dim - 1; ++wall) {
        const double now = depth(X, t, wall), drawn = std::max(0.0, depth(X, 0, wall));
        if (now - drawn > deep * c.fluid().spacing())
          return fmt::format(
              "{}: moves the obstacle into the {} of the tank at t = {:.4g} s; the run fails if particles of "
              "both meet in one place",
              mover.key, wall == dim - 1 ? "floor" : "side", t);
      }
  return "";
}

template <int dim>
std::vector<std::string> doubts_of(const v1::Case& c) {
  std::vector<std::string> all;
  const double end = c.time().end();
  for (const Mover<dim>& mover : movers_of<dim>(c)) {
    const std::vector<double> times = instants(*mover.prescribed, dim, end);
    for (const std::string& doubt : {without_rows(mover.key, *mover.prescribed, dim, end),
                                     too_fast(c, mover, times), into_the_tank(c, mover, times)})
      if (!doubt.empty()) all.push_back(doubt);
  }
  return all;
}

}  // namespace

std::vector<std::string> motion_doubts(const v1::Case& c) {
  return c.dimension() == 2 ? doubts_of<2>(c) : doubts_of<3>(c);
}

}  // namespace cosurge
