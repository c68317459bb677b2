#include "solid_solver/moving_least_squares.hpp"

#include <gtest/gtest.h>

namespace cosurge {
namespace {

std::vector<Vec<2>> block(int columns, int rows) {
  std::vector<Vec<2>> nodes;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) nodes.emplace_back(i + 0.5, j + 0.5);
  return nodes;
}

TEST(MovingLeastSquares, AffineFieldsAreExactInsideAndOutside) {
  const std::vector<Vec<2>> nodes = block(4, 4);
  const Vec<2> gradient(0.7, -1.3);
  for (const Vec<2>& x : {Vec<2>(2, 2), Vec<2>(1.3, 2.9), Vec<2>(0, 0), Vec<2>(4, 1.7), Vec<2>(-0.3, 4.2)}) {
    const Eigen::VectorXd c = moving_least_squares<2>(x, nodes, 2.5);
    ASSERT_EQ(c.size(), 16);
    double value = 0;
    for (int j = 0; j < 16; ++j) value += c[j] * (5 + gradient.dot(nodes[static_cast<std::size_t>(j)]));
    EXPECT_NEAR(c.sum(), 1, 1e-13);  // rounding times the condition of the moments, below 1e3
    EXPECT_NEAR(value, 5 + gradient.dot(x), 1e-12);
  }
}

TEST(MovingLeastSquares, NodesOnALineOrFarAwayGiveNothing) {
  EXPECT_EQ(moving_least_squares<2>({2, 0.6}, block(4, 1), 2.5).size(), 0);
  EXPECT_EQ(moving_least_squares<2>({20, 20}, block(4, 4), 2.5).size(), 0);
}

}  // namespace
}  // namespace cosurge
