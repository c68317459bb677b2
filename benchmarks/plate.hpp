// The plates of the tables: any model under a smooth load, and what its end does.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/timoshenko.hpp"
#include "solid_solver/solid_participant.hpp"

namespace cosurge {

/// A model of an upright plate with its left foot at the origin.
struct PlateCase {
  v1::SolidModel::Word model = v1::SolidModel::mps;
  Cantilever plate;
  int particles = 12;    ///< through the thickness; elements have three of them along a side
  bool clamped = true;   ///< at the foot
  double gravity_x = 0;  ///< [m/s2]

  double spacing() const { return plate.thickness / particles; }
  v1::Case make() const;
};

/// The model, loaded along x at the points of its left face.
class Plate {
 public:
  explicit Plate(const PlateCase& from);

  /// One window under a uniform pressure on the left face [Pa], reached by a ramp.
  void advance(double window, double pressure);
  void advance(double window, const Field& force);

  double value(const std::string& column) const;
  double energy() const {
    return value("kinetic_energy") + value("elastic_energy") + value("gravity_energy");
  }
  Eigen::Index points() const { return interface_.points(); }
  const Setup& setup() const { return setup_; }

 private:
  SolidParticipant solid_;
  Interface interface_;
  Surface surface_;
  Setup setup_;
  Report report_;
  double time_ = 0;
  std::uint64_t windows_ = 0;
};

/// Frequency of free swings [Hz] from the rises through zero of equally spaced samples.
double frequency_of(const std::vector<double>& samples, double interval);

/// First frequency of a plate [Hz]: a pulse as long as a period, then four periods of swinging.
double first_frequency(const PlateCase& plate);

}  // namespace cosurge
