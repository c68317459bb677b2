#include "tests/support/plate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"

namespace cosurge {
namespace {

template <typename Corners>
void set(Corners& box, std::initializer_list<double> min, std::initializer_list<double> max) {
  for (const double x : min) box.add_min(x);
  for (const double x : max) box.add_max(x);
}

}  // namespace

v1::Case PlateCase::make() const {
  v1::Case c;
  c.set_title("plate");
  c.add_gravity(gravity_x);
  c.add_gravity(0);
  v1::Solid& solid = *c.mutable_solid();
  solid.set_model(model);
  solid.mutable_mps()->set_pairs(pairs);
  solid.set_spacing(spacing());
  solid.set_density(plate.density);
  solid.set_young_modulus(plate.young_modulus);
  solid.set_poisson_ratio(plate.poisson_ratio);
  solid.mutable_fem()->set_element(3 * spacing());
  solid.mutable_fem()->set_rho_infinity(1);
  solid.mutable_mps()->set_viscosity(viscosity);
  solid.mutable_hamiltonian()->set_viscosity(viscosity);
  if (steps_of_period > 0) solid.mutable_fem()->set_substep(1 / (steps_of_period * plate.timoshenko()));
  solid.set_damping_ratio(damping_ratio);
  v1::Body& body = *solid.add_body();
  set(*body.mutable_box(), {0, 0}, {plate.thickness, plate.length});
  if (clamped) set(*body.add_clamp(), {0, -4 * spacing()}, {plate.thickness, 0});
  c.mutable_coupling()->set_load(v1::Coupling::ramped);
  v1::Probe& tip = *c.mutable_output()->add_probe();
  tip.set_name("tip");
  tip.set_quantity(v1::Probe::displacement);
  tip.add_position(0.5 * plate.thickness);
  tip.add_position(plate.length);
  return c;
}

Plate::Plate(const PlateCase& from) {
  const double l0 = from.spacing();
  const long rows = std::lround(from.plate.length / l0), columns = from.only_face ? 1 : from.particles;
  interface_ = {.dimension = 2,
                .position = Field(2, rows * columns),
                .area = Field::Zero(2, rows * columns),
                .body = {}};
  for (long k = 0; k < rows * columns; ++k) {
    const long row = k / columns, column = k % columns;
    interface_.position.col(k) << l0 * (static_cast<double>(column) + 0.5),
        l0 * (static_cast<double>(row) + 0.5);
  }
  interface_.body.assign(static_cast<std::size_t>(rows * columns), 0);
  load_ = InterfaceLoad::zero(2, points());
  setup_ = solid_.initialize(from.make(), interface_, load_, motion_);
}

void Plate::advance(double window, const Load& load) {
  for (Eigen::Index p = 0; p < points(); ++p) {
    const Vec<2> force = load({interface_.position(0, p), interface_.position(1, p)});
    load_.force.col(p) << force[0], force[1];
  }
  report_ = solid_.advance({.index = windows_++, .start = time_, .size = window}, load_, motion_);
  time_ += window;
}

double Plate::value(const std::string& column) const {
  for (std::size_t k = 0; k < setup_.columns.size(); ++k)
    if (setup_.columns[k].name == column) return report_.values[k];
  throw Error("no column " + column);
}

double swing_frequency(const PlateCase& from, double expected, const Vec<2>& direction) {
  constexpr int per_period = 200, periods = 4;
  const double window = 1 / (expected * per_period);
  Plate plate(from);
  // An acceleration that moves the end by about 1e-4 of the length. The pulse's spectrum is zero at all
  // multiples of the frequency from the second on, and small between them.
  const double force = 1e-4 * from.plate.length * std::pow(expected * 2 * std::numbers::pi, 2) *
                       from.plate.density * from.plate.length * from.plate.thickness /
                       static_cast<double>(plate.points());
  std::vector<double> rises;
  double before = 0;
  for (int k = 1; k <= (periods + 2) * per_period; ++k) {
    const double phase = std::min(1.0, static_cast<double>(k) / per_period);
    const double share = force * std::pow(std::sin(std::numbers::pi * phase), 2);
    plate.advance(window, [&](const Vec<2>&) { return Vec<2>(share * direction); });
    const double now = plate.tip().dot(direction);
    if (k > per_period && before < 0 && now >= 0) rises.push_back((k - now / (now - before)) * window);
    before = now;
  }
  require(rises.size() > 1, "no swing to time");
  return static_cast<double>(rises.size() - 1) / (rises.back() - rises.front());
}

}  // namespace cosurge
