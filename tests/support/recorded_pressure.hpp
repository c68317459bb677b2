// A recorded pressure on a face.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Pressures from a CSV file. First line: an unused number, then the heights of the gauges. Every further
/// line: a time and the pressures. Lines that begin with # are left out.
class RecordedPressure {
 public:
  /// @throws Error for a file that is missing or not such a table
  explicit RecordedPressure(const std::string& file);

  const std::vector<double>& times() const { return times_; }  ///< [s]

  /// Pressure at a height and an instant [Pa], linear between the gauges and constant beyond them.
  double at(std::size_t instant, double height) const;

 private:
  std::vector<double> heights_, times_;
  std::vector<std::vector<double>> pressures_;  // pressures at each instant
};

}  // namespace cosurge
