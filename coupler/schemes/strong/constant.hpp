// Relaxation by a constant factor.
#pragma once

#include "coupler/schemes/strong/relaxation.hpp"

namespace cosurge {

/// x + omega r. Converges where 0 < omega < 2 / (1 + mu), the fastest at 1 / (1 + mu).
class Constant : public Relaxation {
 public:
  explicit Constant(double omega) : omega_(omega) {}

  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) override {
    return x + omega_ * residual;
  }

 private:
  double omega_;
};

}  // namespace cosurge
