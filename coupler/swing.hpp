// Numbers that describe how a coupled run behaves, for tables that compare many runs.
#pragma once

#include <string>
#include <vector>

#include "coupler/coupler.hpp"

namespace cosurge {

/// Observes the alternation of the load, the work, and one displacement.
class Swing : public Observer {
 public:
  /// @param coupler the coupler of the observed run
  explicit Swing(const Coupler& coupler);

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

  std::size_t windows() const { return time_.size(); }
  double end() const { return time_.empty() ? 0 : time_.back(); }  ///< [s]
  double iterations() const;                                       ///< mean number of iterations per window
  double largest_ratio() const;                                    ///< largest estimated added mass ratio

  /// rms change of the load from window to window in the last quarter of the run, over that in the second
  /// quarter.
  double alternation() const;
  double created() const;  ///< work created by the scheme over the absolute work of all windows

  /// Whether the load alternates from window to window in the last quarter of the run: on average each change
  /// reverses 90 % of the one before, and the rms change exceeds half of the rms load, or three times the rms
  /// change of the second quarter. The former happens in an instability that the cut-off of suction bounds,
  /// the latter in a growing one. Noise reverses half of each change.
  bool alternates() const;

  /// Judgement of a run that has reached its end. "growing": it alternates(), or the scheme has created more
  /// than a twentieth of the work that passed; "draining": it has destroyed as much; otherwise "stable".
  const char* judgement() const;

  /// Frequency of the most-moving component of the first displacement probe, from the first to the last
  /// upward passage through its mean over the second half of the run [Hz]; 0 with fewer than two passages.
  double frequency() const;
  double peak() const;       ///< its largest value [m]
  double peak_time() const;  ///< [s]
  double amplitude() const;  ///< half its range in the second half of the run [m]

 private:
  double mean_change(double from, double to) const;
  const std::vector<double>& displacement() const;

  std::size_t solid_ = 0;                // index of the solid among the reports
  std::vector<std::size_t> components_;  // columns of the probe
  std::size_t dimension_;
  std::vector<double> time_, work_, created_, iterations_, ratio_;
  std::vector<std::vector<double>> force_;         // one component each
  std::vector<std::vector<double>> displacement_;  // one component each
};

}  // namespace cosurge
