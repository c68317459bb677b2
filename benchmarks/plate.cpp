#include "benchmarks/plate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"

namespace cosurge {
namespace {

void set(v1::Box& box, std::initializer_list<double> min, std::initializer_list<double> max) {
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
  solid.set_spacing(spacing());
  solid.set_density(plate.density);
  solid.set_young_modulus(plate.young_modulus);
  solid.set_poisson_ratio(plate.poisson_ratio);
  solid.mutable_fem()->set_element(3 * spacing());
  solid.mutable_fem()->set_rho_infinity(1);
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
  const auto rows = static_cast<Eigen::Index>(std::lround(from.plate.length / from.spacing()));
  interface_ = {.dimension = 2, .position = Field(2, rows), .area = Field::Zero(2, rows), .body = {}};
  for (Eigen::Index j = 0; j < rows; ++j) {
    interface_.position.col(j) << 0.5 * from.spacing(), (static_cast<double>(j) + 0.5) * from.spacing();
    interface_.area(0, j) = -from.spacing();
  }
  interface_.body.assign(static_cast<std::size_t>(rows), 0);
  setup_ = solid_.initialize(from.make(), interface_, surface_);
}

void Plate::advance(double window, double pressure) { advance(window, Field(-pressure * interface_.area)); }

void Plate::advance(double window, const Field& force) {
  surface_.force = force;
  report_ = solid_.advance({.index = windows_++, .start = time_, .size = window}, surface_);
  time_ += window;
}

double Plate::value(const std::string& column) const {
  for (std::size_t k = 0; k < setup_.columns.size(); ++k)
    if (setup_.columns[k].name == column) return report_.values[k];
  throw Error("no column " + column);
}

double frequency_of(const std::vector<double>& samples, double interval) {
  std::vector<double> rises;
  for (std::size_t k = 1; k < samples.size(); ++k)
    if (samples[k - 1] < 0 && samples[k] >= 0)
      rises.push_back((static_cast<double>(k) - samples[k] / (samples[k] - samples[k - 1])) * interval);
  require(rises.size() > 1, "no swing to time");
  return static_cast<double>(rises.size() - 1) / (rises.back() - rises.front());
}

double first_frequency(const PlateCase& from) {
  constexpr int per_period = 200, periods = 4;
  const double expected = from.plate.timoshenko(), window = 1 / (expected * per_period);
  // Deflects by 1e-4 of the length; smooth, so that the second mode, six times as fast, gets 1e-3 of the
  // first's.
  const double pressure = 1e-4 * from.plate.length / from.plate.deflection();
  Plate plate(from);
  std::vector<double> tip;
  for (int k = 1; k <= (periods + 2) * per_period; ++k) {
    const double phase = std::min(1.0, static_cast<double>(k) / per_period);
    plate.advance(window, pressure * std::pow(std::sin(std::numbers::pi * phase), 2));
    if (k > per_period) tip.push_back(plate.value("tip_x"));
  }
  return frequency_of(tip, window);
}

}  // namespace cosurge
