#include "common/geometry/shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/case/from_case.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge::testing {
namespace {

using ::testing::HasSubstr;

/// A polygon, or the triangles of a body, from a flat list.
v1::Shape outline(const std::vector<double>& vertices) {
  v1::Shape shape;
  shape.mutable_vertex()->Assign(vertices.begin(), vertices.end());
  return shape;
}

/// An octahedron around c: |x - c| + |y - c| + |z - c| < r.
v1::Shape octahedron(double c, double r) {
  std::vector<double> vertices;
  for (const double sx : {-r, r})
    for (const double sy : {-r, r})
      for (const double sz : {-r, r})
        for (const double v : {c + sx, c, c, c, c + sy, c, c, c, c + sz}) vertices.push_back(v);
  return outline(vertices);
}

TEST(Shape, APolygonHoldsTheSitesInsideAndAsManyAsItsAreaSays) {
  // An L of 0.4 x 0.4 without a quarter: area 0.12. The lattice fits its sides.
  const auto shape = from_case<2>(outline({0, 0, 0.4, 0, 0.4, 0.2, 0.2, 0.2, 0.2, 0.4, 0, 0.4}));
  const auto sites = shape.fill(0.01);
  EXPECT_EQ(sites.size(), 1200);
  for (const Vec<2>& x : sites) EXPECT_FALSE(x[0] > 0.2 && x[1] > 0.2) << x.transpose();
  EXPECT_TRUE(shape.contains({0.1, 0.3}));
  EXPECT_FALSE(shape.contains({0.3, 0.3}));
  EXPECT_FALSE(shape.contains({-0.1, 0.1}));
}

TEST(Shape, TheOrderOfThePolygonsCornersDoesNotMatter) {
  const auto shape = from_case<2>(outline({0, 0.4, 0.2, 0.4, 0.2, 0.2, 0.4, 0.2, 0.4, 0, 0, 0}));
  EXPECT_EQ(shape.fill(0.01).size(), 1200);
}

TEST(Shape, ABodyOfTrianglesHoldsWhatItsInequalitySays) {
  // The centre is a site, so that the rays meet corners and edges.
  const double c = 0.505, r = 0.3;
  const auto shape = from_case<3>(octahedron(c, r));
  int inside = 0;
  for (const Vec<3>& x : fill(Box<3>(Vec<3>::Zero(), Vec<3>::Ones()), 0.02)) {
    const double distance = (x.array() - c).abs().sum();
    if (std::abs(distance - r) < 1e-6) continue;
    EXPECT_EQ(shape.contains(x), distance < r) << x.transpose();
    inside += distance < r ? 1 : 0;
  }
  EXPECT_NEAR(inside * 8e-6, 4.0 / 3 * r * r * r, 0.02 * 0.036);  // a layer of sites more or less
}

/// A good case whose second water is an outline in a file.
struct OutlinedCase {
  explicit OutlinedCase(const std::string& lines) {
    std::ofstream(std::filesystem::path(text.file()).parent_path() / "shape.csv") << lines;
  }
  CaseText text{"{ min = [0.15, 0.0], max = [0.2, 0.2] }", "{ outline = \"shape.csv\" }"};
};

TEST(CaseTables, AnOutlineIsReadIntoTheCase) {
  const OutlinedCase c("# x, y\n0.15, 0\n0.2, 0\n0.2 0.1\r\n");
  const v1::Case read = load_case(c.text.file());
  ASSERT_EQ(read.fluid().water(1).vertex_size(), 6);
  EXPECT_EQ(read.fluid().water(1).vertex(5), 0.1);
}

TEST(CaseTables, WhatIsWrongInAFileIsSaidWithItsLine) {
  EXPECT_THAT(errors_of(OutlinedCase("0, 0\n1, 2, 3\n").text.file()),
              HasSubstr("shape.csv:2: must be 2 numbers"));
  EXPECT_THAT(errors_of(OutlinedCase("0, 0\n1, a\n").text.file()),
              HasSubstr("shape.csv:2: must be 2 numbers"));
  EXPECT_THAT(errors_of(OutlinedCase("0, 0\n1, 1\n").text.file()),
              HasSubstr("fluid.water.1: the outline has 2 corners, needs at least 3"));
  const CaseText missing("{ min = [0.15, 0.0], max = [0.2, 0.2] }", "{ outline = \"nothing.csv\" }");
  EXPECT_THAT(errors_of(missing.file()), HasSubstr("nothing.csv: no such file"));
}

/// A text STL of a tetrahedron, and the same in binary.
void write_stl(const std::filesystem::path& file, bool binary) {
  const std::array<std::array<float, 9>, 4> facets = {{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                       {0, 0, 0, 1, 0, 0, 0, 0, 1},
                                                       {0, 0, 0, 0, 1, 0, 0, 0, 1},
                                                       {1, 0, 0, 0, 1, 0, 0, 0, 1}}};
  std::ofstream out(file, std::ios::binary);
  if (binary) {
    const std::string head(80, ' ');
    const std::uint32_t count = facets.size();
    out << head;
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
  } else {
    out << "solid tetrahedron\n";
  }
  for (const auto& corners : facets) {
    const std::array<float, 3> normal{};
    const std::uint16_t attributes = 0;
    if (binary) {
      out.write(reinterpret_cast<const char*>(normal.data()), sizeof normal);
      out.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
      out.write(reinterpret_cast<const char*>(&attributes), sizeof attributes);
      continue;
    }
    out << "facet normal 0 0 0\nouter loop\n";
    for (std::size_t k = 0; k < corners.size(); k += 3)
      out << "vertex " << corners[k] << " " << corners[k + 1] << " " << corners[k + 2] << "\n";
    out << "endloop\nendfacet\n";
  }
  if (!binary) out << "endsolid\n";
}

TEST(CaseTables, StlIsReadInTextAndInBinary) {
  for (const bool binary : {false, true}) {
    const ScratchFolder folder;
    write_stl(folder.path() / "shape.stl", binary);
    std::ofstream(folder.path() / "case.toml") << R"(title = "Tetrahedron"
dimension = 3
gravity = [0, 0, -9.81]
time = { end = 0.1, window = 1e-3 }
[fluid]
spacing = 0.05
tank = { min = [0, 0, 0], max = [1, 1, 1] }
water = [{ outline = "shape.stl" }]
)";
    const v1::Case c = load_case(folder.path().string());
    ASSERT_EQ(c.fluid().water(0).vertex_size(), 36) << binary;
    const auto sites = from_case<3>(c.fluid().water(0)).fill(0.05);
    // x + y + z < 1 on the sites (k + 1/2) / 20: the sum of the three k is at most 18.
    EXPECT_EQ(sites.size(), 19 * 20 * 21 / 6) << binary;
  }
}

}  // namespace
}  // namespace cosurge::testing
