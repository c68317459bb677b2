// Relaxation by a factor from the last two iterations.
#pragma once

#include <algorithm>

#include "coupler/schemes/strong/relaxation.hpp"

namespace cosurge {

/// Aitken's delta-squared method for vectors: omega_k = - omega_(k-1) r_(k-1) . dr / |dr|^2, dr = r_k -
/// r_(k-1) (Irons & Tuck 1969; Kuettler & Wall 2008, doi 10.1007/s00466-008-0255-5). A window starts with the
/// last factor of the previous one. Since the added mass is positive, 1 / (1 + mu) <= omega <= 1; values
/// outside this range come from noise and are limited to it.
class Aitken : public Relaxation {
 public:
  explicit Aitken(double first) : omega_(first) {}

  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) override {
    if (last_.size() > 0) {
      const Eigen::VectorXd change = residual - last_;
      const double square = change.squaredNorm();
      if (square > 0) omega_ = std::clamp(-omega_ * last_.dot(change) / square, smallest, 1.0);
    }
    last_ = residual;
    return x + omega_ * residual;
  }

  void end_window() override { last_.resize(0); }

  void save(StateWriter& state) const override { state.put(omega_); }
  void restore(InterfaceReader& state) override { state.get(omega_); }

 private:
  static constexpr double smallest = 1e-3;  // for mu = 1000; with less, an iteration hardly moves

  double omega_;
  Eigen::VectorXd last_;  // residual of the last iteration of this window
};

}  // namespace cosurge
