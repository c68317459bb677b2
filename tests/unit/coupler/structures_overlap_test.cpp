#include "coupler/structures_overlap.hpp"

#include <gtest/gtest.h>

namespace cosurge {
namespace {

TEST(StructuresOverlap, IsFoundWhereAComparisonOfAllPairsFindsOne) {
  std::srand(4);
  constexpr int points = 60;
  int found = 0;
  for (int round = 0; round < 50; ++round) {
    const Field places = Field::Random(3, points);
    std::vector<int> structure;
    for (int p = 0; p < points; ++p) structure.push_back(std::rand() % 3);
    constexpr double distance = 0.15;
    bool any = false;
    for (int a = 0; a < points; ++a)
      for (int b = 0; b < a; ++b)
        any = any || (structure[static_cast<std::size_t>(a)] != structure[static_cast<std::size_t>(b)] &&
                      (places.col(a) - places.col(b)).norm() < distance);
    const auto overlap = find_overlap(places, structure, distance);
    ASSERT_EQ(overlap.has_value(), any) << round;
    if (!overlap) continue;
    ++found;
    EXPECT_NE(structure[static_cast<std::size_t>(overlap->first)],
              structure[static_cast<std::size_t>(overlap->second)]);
    EXPECT_LT((places.col(overlap->first) - places.col(overlap->second)).norm(), distance);
  }
  EXPECT_GT(found, 5);
  EXPECT_LT(found, 45);
}

}  // namespace
}  // namespace cosurge
