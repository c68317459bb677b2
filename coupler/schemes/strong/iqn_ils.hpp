// Interface quasi-Newton with an inverse Jacobian from a least-squares problem.
#pragma once

#include <deque>

#include "coupler/schemes/strong/relaxation.hpp"

namespace cosurge {

/// Degroote, Bathe & Vierendeels 2009 (doi 10.1016/j.compstruc.2008.11.013). The columns dr and dg are the
/// changes of residuals and outputs between iterations in this window and the last ones: alpha = argmin |r +
/// dr alpha|, x = g + dg alpha. Columns that are nearly combinations of newer ones are left out (QR2 filter:
/// Haelterman et al. 2016, doi 10.1016/j.compstruc.2015.11.007). If a step has increased the residual,
/// water has arrived or left, and past windows are no longer valid: their columns are dropped. If this
/// happens repeatedly, suction is cut off at other points in every iteration, and older columns are invalid
/// slopes: all but the newest are dropped. Added mass is positive, so that the step (1 + M)^-1 r is not
/// longer than r: a longer step comes from noise in the columns, and is shortened.
class IqnIls : public Relaxation {
 public:
  /// @param first factor of the first iteration, while there are no columns
  /// @param reuse windows whose columns are kept besides the present one's
  IqnIls(double first, int reuse) : first_(first), reuse_(reuse) {}

  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) override;
  void end_window() override;

  void save(StateWriter& state) const override;
  void restore(InterfaceReader& state) override;

 private:
  /// Between two iterations.
  struct Change {
    Eigen::VectorXd residual;
    Eigen::VectorXd output;
  };

  void forget();

  double first_;
  int reuse_;
  std::deque<Change> changes_;                   // newest first
  std::deque<int> counts_ = {0};                 // number of changes in each window, newest first
  int growths_ = 0;                              // how often the residual has grown in this window
  Eigen::VectorXd last_residual_, last_output_;  // residual and output of the last iteration of this window
};

}  // namespace cosurge
