#include "common/geometry/facet_tree.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace cosurge {
namespace {

/// A tree of all facets answers as trees of one facet each do together.
template <int dim>
void compare_with_single_facets() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] {
    Vec<dim> x;
    for (double& coordinate : x) coordinate = place(random);
    return x;
  };
  std::vector<Facet<dim>> facets(200);
  for (Facet<dim>& facet : facets) {
    const Vec<dim> centre = point();
    for (Vec<dim>& corner : facet) corner = centre + 0.2 * point();
  }
  const FacetTree<dim> tree(facets);
  for (int k = 0; k < 500; ++k) {
    const Vec<dim> x = 1.5 * point();
    double least = std::numeric_limits<double>::infinity();
    int crossings = 0;
    for (const Facet<dim>& facet : facets) {
      const FacetTree<dim> single({facet});
      least = std::min(least, single.nearest(x).distance_squared);
      crossings += single.crossings(x);
    }
    EXPECT_EQ(tree.nearest(x).distance_squared, least);
    EXPECT_EQ(tree.crossings(x), crossings);
  }
}

TEST(FacetTree, FindsWhatASearchThroughAllFacetsFinds) {
  compare_with_single_facets<2>();
  compare_with_single_facets<3>();
}

}  // namespace
}  // namespace cosurge
