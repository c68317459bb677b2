#include "coupler/schemes/strong/iqn_ils.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cosurge {
namespace {

constexpr int unknowns = 12;
constexpr int limit = 40;

/// Added mass over mass at points that the water wets: ratios up to `largest` on motions that a reflection
/// makes.
struct AddedMass {
  Eigen::VectorXd normal, ratios;

  AddedMass(double largest, unsigned seed) : normal(unknowns), ratios(unknowns) {
    std::mt19937 random(seed);
    std::normal_distribution<double> coordinate;
    for (int k = 0; k < unknowns; ++k) {
      normal[k] = coordinate(random);
      ratios[k] = largest * std::pow(0.4, k);
    }
    normal.normalize();
    std::shuffle(ratios.begin(), ratios.end(), random);
  }

  Eigen::VectorXd reflected(const Eigen::VectorXd& x) const { return x - 2 * normal.dot(x) * normal; }
  Eigen::VectorXd of(const Eigen::VectorXd& x) const { return reflected(ratios.cwiseProduct(reflected(x))); }
};

/// Iterations of one window to a residual of 1e-3, x = g(x) = 1 - M x.
int iterate(IqnIls& relaxation, const AddedMass& M) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns);
  for (int k = 1; k <= limit; ++k) {
    const Eigen::VectorXd g = Eigen::VectorXd::Ones(unknowns) - M.of(x);
    const Eigen::VectorXd residual = g - x;
    if (residual.norm() <= 1e-3 * g.norm()) {
      relaxation.end_window();
      return k;
    }
    x = relaxation.next(x, residual);
  }
  return limit;
}

TEST(IqnIls, WindowsWithTheSameAddedMassBecomeCheap) {
  IqnIls relaxation(0.5, 5);
  const AddedMass M(20, 1);
  const int first = iterate(relaxation, M);
  for (int k = 0; k < 4; ++k) iterate(relaxation, M);
  EXPECT_GE(first, 5);
  EXPECT_LE(iterate(relaxation, M), 2);  // all modes that the right-hand side excites are known
}

TEST(IqnIls, WhatPastWindowsHaveShownDoesNotHinderOneWhoseWaterHasGoneElsewhere) {
  // Added mass on other motions altogether, as when a jet leaves the plate and another one arrives.
  for (unsigned seed = 2; seed < 12; ++seed) {
    IqnIls fresh(0.5, 0), reusing(0.5, 5);
    for (int k = 0; k < 5; ++k) iterate(reusing, AddedMass(20, 1));
    const AddedMass other(20, seed);
    // One or two steps with the outdated columns, then as without them.
    EXPECT_LE(iterate(reusing, other), iterate(fresh, other) + 2) << seed;
  }
}

TEST(IqnIls, ConvergesWhereSuctionIsCutOffAtOtherPointsInEveryIteration) {
  // g(x) = c + max(0, p - M x): pressures on both sides of zero, added mass that falls off slowly, up to 7.5.
  // With all columns of the window kept, 42 of the windows did not converge in thirty iterations.
  std::mt19937 random(3);
  std::normal_distribution<double> unit;
  IqnIls relaxation(0.5, 5);
  Eigen::MatrixXd M(unknowns, unknowns);
  for (int i = 0; i < unknowns; ++i)
    for (int j = 0; j < unknowns; ++j) M(i, j) = std::exp(-2.5 * std::abs(i - j) / unknowns);
  M *= 7.5 / M.rowwise().sum().maxCoeff();  // largest row sum 7.5, an upper bound of the eigenvalues
  int converged = 0;
  constexpr int windows = 200;
  for (int window = 0; window < windows; ++window) {
    Eigen::VectorXd p(unknowns), c(unknowns), x = Eigen::VectorXd::Zero(unknowns);
    for (int k = 0; k < unknowns; ++k) p[k] = 0.5 + unit(random), c[k] = 0.1 * unit(random);
    for (int k = 1; k <= 30; ++k) {
      const Eigen::VectorXd g = c + (p - M * x).cwiseMax(0), residual = g - x;
      if (residual.norm() <= 1e-3 * g.norm()) {
        ++converged;
        break;
      }
      x = relaxation.next(x, residual);
    }
    relaxation.end_window();
  }
  EXPECT_EQ(converged, windows);
}

}  // namespace
}  // namespace cosurge
