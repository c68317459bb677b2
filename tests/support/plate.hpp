// The plates of the tables: any model under a smooth load, and the displacement of its end.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "common/vec.hpp"
#include "proto/case.pb.h"
#include "solid_solver/solid_participant.hpp"
#include "tests/support/timoshenko.hpp"

namespace cosurge {

/// A model of an upright plate with its left foot at the origin.
struct PlateCase {
  v1::SolidModel::Word model = v1::SolidModel::mps;
  v1::SolidMps::Pairs pairs = v1::SolidMps::corrected;  ///< for `mps`
  Cantilever plate;
  int particles = 12;    ///< number through the thickness; elements have a side of three spacings
  bool clamped = true;   ///< at the foot
  double gravity_x = 0;  ///< [m/s2]
  double damping_ratio = 0;
  int steps_of_period = 0;  ///< for `fem`: least number of steps in the first period; 0: one step per window
  double viscosity = 0;     ///< for `mps` and `hamiltonian`
  bool only_face =
      false;  ///< points on the left face only, as the water has them; otherwise in the whole plate

  double spacing() const { return plate.thickness / particles; }
  v1::Case make() const;
};

/// The model under loads at its points, ramped over every window. "tip" is the middle of its end.
class Plate {
 public:
  explicit Plate(const PlateCase& from);

  /// Force at a point X [N].
  using Load = std::function<Vec<2>(const Vec<2>&)>;
  void advance(double window, const Load& load);

  double value(const std::string& column) const;
  Vec<2> tip() const { return {value("tip_x"), value("tip_y")}; }
  double energy() const {
    return value("kinetic_energy") + value("elastic_energy") + value("gravity_energy");
  }
  Eigen::Index points() const { return interface_.points(); }
  const Setup& setup() const { return setup_; }

 private:
  SolidParticipant solid_;
  Interface interface_;
  InterfaceMotion motion_;
  InterfaceLoad load_;
  Setup setup_;
  Report report_;
  double time_ = 0;
  std::uint64_t windows_ = 0;
};

/// Frequency [Hz] of the free swings after a pulse on the whole plate, as long as a period is expected to be,
/// along `direction`: four periods, in windows of 1/200.
double swing_frequency(const PlateCase& plate, double expected, const Vec<2>& direction);

}  // namespace cosurge
