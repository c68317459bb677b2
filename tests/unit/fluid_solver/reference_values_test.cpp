#include "fluid_solver/reference_values.hpp"

#include <gtest/gtest.h>

namespace cosurge::fluid {
namespace {

struct Row {
  double re;
  double n0;
  double lambda0;
};

// Sums computed independently of this program, printed to five decimals.
constexpr Row plane[] = {{2.1, 6.53970, 1.38835}, {3.1, 18.97642, 2.44847}, {4.0, 35.60922, 3.70710}};
constexpr Row space[] = {{2.1, 14.41858, 1.70174}, {3.1, 54.32121, 3.24342}, {4.0, 123.99156, 5.21199}};
constexpr double printed = 6e-6;  // half of the last digit, and its rounding

TEST(ReferenceValues, AreTheSumsOverTheSquareLattice) {
  for (const Row& row : plane) {
    const ReferenceValues values = reference_values<2>(row.re, 1);
    EXPECT_NEAR(values.n0, row.n0, printed) << row.re;
    EXPECT_NEAR(values.lambda0, row.lambda0, printed) << row.re;
  }
}

TEST(ReferenceValues, AreTheSumsOverTheCubicLattice) {
  for (const Row& row : space) {
    const ReferenceValues values = reference_values<3>(row.re, 1);
    EXPECT_NEAR(values.n0, row.n0, printed) << row.re;
    EXPECT_NEAR(values.lambda0, row.lambda0, printed) << row.re;
  }
}

TEST(ReferenceValues, ScaleWithTheSpacing) {
  for (const double spacing : {0.001, 0.003, 7.0}) {
    const ReferenceValues values = reference_values<2>(4.0 * spacing, spacing);
    EXPECT_NEAR(values.n0 / reference_values<2>(4.0, 1).n0, 1, 1e-12);  // rounding of sums of 44 terms
    EXPECT_NEAR(values.lambda0 / (spacing * spacing * reference_values<2>(4.0, 1).lambda0), 1, 1e-12);
  }
}

}  // namespace
}  // namespace cosurge::fluid
