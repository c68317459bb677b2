// Relaxation of a fixed-point iteration.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "coupler/interface_reader.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// Solves g(x) = x from values of g alone. In each window, next() is called after every iteration that has
/// not converged, then end_window().
class Relaxation {
 public:
  virtual ~Relaxation() = default;

  /// The next x, from the last one and its residual r = g(x) - x.
  virtual Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& residual) = 0;
  virtual void end_window() {}

  virtual void save(StateWriter&) const {}
  virtual void restore(InterfaceReader&) {}
};

/// Creates the method of `coupling.iteration.relaxation`.
std::unique_ptr<Relaxation> make_relaxation(const v1::Iteration& iteration);

}  // namespace cosurge
