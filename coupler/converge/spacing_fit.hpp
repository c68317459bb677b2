// How a quantity and the cost of a run depend on the spacing.
#pragma once

#include <vector>

namespace cosurge {

/// One run at a spacing [m].
struct SpacingSample {
  double spacing;
  double value;         ///< of the quantity
  double core_seconds;  ///< of the run
};

/// Q(h) = Q0 + C h by least squares, with the standard deviation s of the values from that line. A run at h
/// is then expected to be off by sqrt((C h)^2 + s^2): the error of the spacing, and what runs scatter by that
/// differ by nothing but rounding. The order is 1 because the water's is (docs/verification.md, Convergence);
/// a quantity of a higher order is more accurate than the line says.
class SpacingFit {
 public:
  /// @throws Error with fewer than three samples or fewer than two different spacings.
  explicit SpacingFit(const std::vector<SpacingSample>& samples);

  double limit() const { return limit_; }  ///< Q0, for a spacing of zero
  double value(double spacing) const { return limit_ + slope_ * spacing; }
  double scatter() const;              ///< s / |Q0|
  double error(double spacing) const;  ///< expected error of a run / |Q0|

  /// Largest spacing [m] with at most this relative error; 0 where no spacing has, because of the scatter.
  double spacing_for(double error) const;

 private:
  double limit_ = 0;
  double slope_ = 0;
  double deviation_ = 0;
};

/// t(h) = t1 (h1 / h)^q: t1 at the finest spacing h1, q by the two finest spacings. Coarser runs are left
/// out, because their cost has a larger share that does not depend on the spacing.
class CostFit {
 public:
  /// `dimension` + 1 is the q of steps and particles, and q stays within 1 of it.
  /// @throws Error with fewer than two different spacings.
  CostFit(const std::vector<SpacingSample>& samples, int dimension);

  double core_seconds(double spacing) const;
  double spacing_for(double core_seconds) const;  ///< [m]

 private:
  double finest_ = 0;
  double seconds_ = 0;
  double power_ = 0;
};

}  // namespace cosurge
