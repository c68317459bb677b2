#include "solid_solver/models/particles/highest_frequency.hpp"

#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"

namespace cosurge::particles {
namespace {

/// The stiffness as an operator for Spectra.
struct Operator {
  using Scalar = double;
  Eigen::Index size;
  const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply;

  Eigen::Index rows() const { return size; }
  Eigen::Index cols() const { return size; }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, size) = apply(Eigen::Map<const Eigen::VectorXd>(x, size));
  }
};

}  // namespace

double highest_frequency(std::size_t unknowns,
                         const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& stiffness) {
  Operator op{.size = static_cast<Eigen::Index>(unknowns), .apply = stiffness};
  Spectra::SymEigsSolver solver(op, 1, static_cast<int>(std::min<Eigen::Index>(20, op.size)));
  solver.init();
  constexpr double tolerance = 1e-4;
  solver.compute(Spectra::SortRule::LargestAlge, 1000, tolerance);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw NumericalError("solid: the highest frequency of a body did not converge");
  // Factor for the tolerance, so that the result is an upper limit.
  return std::sqrt(solver.eigenvalues()[0] * (1 + tolerance));
}

}  // namespace cosurge::particles
