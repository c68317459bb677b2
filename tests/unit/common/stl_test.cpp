#include "common/geometry/stl.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "common/case/from_case.hpp"
#include "common/error.hpp"
#include "common/geometry/shape.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using testing::errors_of;
using ::testing::HasSubstr;
using Triangles = std::vector<std::array<double, 9>>;

/// A box, its triangles ordered so that they are seen counterclockwise from outside.
Triangles box(const std::array<double, 3>& min, const std::array<double, 3>& max) {
  // Corners by bits: 1 is max of x, 2 of y, 4 of z.
  constexpr std::array<std::array<int, 3>, 12> faces = {{{0, 2, 1},
                                                         {1, 2, 3},
                                                         {4, 5, 6},
                                                         {5, 7, 6},
                                                         {0, 1, 4},
                                                         {1, 5, 4},
                                                         {2, 6, 3},
                                                         {3, 6, 7},
                                                         {0, 4, 2},
                                                         {2, 4, 6},
                                                         {1, 3, 5},
                                                         {3, 7, 5}}};
  Triangles triangles;
  for (const auto& face : faces) {
    std::array<double, 9> t{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) t[3 * c + k] = (face[c] >> k & 1) != 0 ? max[k] : min[k];
    triangles.push_back(t);
  }
  return triangles;
}

Triangles inside_out(Triangles triangles) {
  for (auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) std::swap(t[3 + k], t[6 + k]);
  return triangles;
}

Triangles with_one_turned(Triangles triangles) {
  for (std::size_t k = 0; k < 3; ++k) std::swap(triangles[5][3 + k], triangles[5][6 + k]);
  return triangles;
}

Triangles operator+(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string text_of(const Triangles& triangles, const std::string& name = "box") {
  std::string text = "solid " + name + "\n";
  for (const auto& t : triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (std::size_t c = 0; c < 9; c += 3)
      text += fmt::format("   vertex {} {} {}\n", t[c], t[c + 1], t[c + 2]);
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

std::string binary_of(const Triangles& triangles, const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80, '\0');
  const auto count = static_cast<std::uint32_t>(triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& t : triangles) {
    std::array<float, 12> values{};
    for (std::size_t k = 0; k < 9; ++k) values[3 + k] = static_cast<float>(t[k]);
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof values);
    bytes.append(2, '\0');
  }
  return bytes;
}

/// With another number of triangles in the header.
std::string counting(std::string bytes, std::uint32_t count) {
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  return bytes;
}

Triangles magnified(Triangles triangles, double factor) {
  for (auto& t : triangles)
    for (double& x : t) x *= factor;
  return triangles;
}

Triangles moved(Triangles triangles, double by) {
  for (auto& t : triangles)
    for (double& x : t) x += by;
  return triangles;
}

/// Numbers such as 2.000000e-01.
std::string with_exponents(const Triangles& triangles) {
  std::string text = "solid box\n";
  for (const auto& t : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::size_t c = 0; c < 9; c += 3)
      text += fmt::format("vertex {:.6e} {:+.6E} {:e}\n", t[c], t[c + 1], t[c + 2]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// A tank of 0.4 x 0.2 x 0.3 m with an obstacle from an STL.
struct Scene {
  explicit Scene(const std::string& stl, const std::string& keys = "") {
    std::ofstream(folder.path() / "shape.stl", std::ios::binary) << stl;
    std::ofstream(folder.path() / "case.toml") << fmt::format(R"(title = "STL"
dimension = 3
gravity = [0, 0, -9.81]
time = {{ end = 0.1, window = 1e-3 }}
[fluid]
spacing = 0.02
tank = {{ min = [0, 0, 0], max = [0.4, 0.2, 0.3] }}
water = [{{ min = [0, 0, 0], max = [0.1, 0.2, 0.1] }}]
obstacle = [{{ shape = {{ outline = "shape.stl"{}{} }} }}]
)",
                                                              keys.empty() ? "" : ", ", keys);
  }

  std::string errors() const { return errors_of(folder.path().string()); }

  std::size_t sites() const {
    return from_case<3>(load_case(folder.path().string()).fluid().obstacle(0).shape()).fill(0.02).size();
  }

  testing::ScratchFolder folder;
};

const Triangles block = box({0.2, 0.04, 0}, {0.3, 0.1, 0.1});
constexpr std::size_t block_sites = 5 * 3 * 5;
const Triangles beside = box({0.26, 0.04, 0}, {0.36, 0.1, 0.1});  // shares 2 x 3 x 5 sites with the block

struct Kind {
  std::string name;
  std::string bytes;
  std::size_t sites;
  std::string keys = "";
};

const Kind kinds[] = {
    {"Text", text_of(block), block_sites},
    {"Binary", binary_of(block), block_sites},
    {"BinaryThatBeginsWithSolid", binary_of(block, "solid by some program"), block_sites},
    {"Capitals", upper(text_of(block)), block_sites},
    {"CapitalizedWords", replaced(replaced(text_of(block), "solid", "Solid"), "vertex", "Vertex"),
     block_sites},
    {"LeadingBlanks", "  \n\t" + text_of(block), block_sites},
    {"ByteOrderMark", "\xEF\xBB\xBF" + text_of(block), block_sites},
    {"WindowsLines", replaced(text_of(block), "\n", "\r\n"), block_sites},
    {"NameWithTheWordVertex", text_of(block, "vertex 1 2 3 of facet"), block_sites},
    {"NoName", text_of(block, ""), block_sites},
    {"ZerosBehindTheText", text_of(block) + std::string(40, '\0'), block_sites},
    {"WordsBehindTheText", text_of(block) + "made by some program\n", block_sites},
    {"BytesBehindTheBinary", binary_of(block) + "made by some program", block_sites},
    {"BytesBehindTheBinaryThatBeginsWithSolid", binary_of(block, "solid block") + "made", block_sites},
    {"TwoSolidsInOneText", text_of(block) + text_of(box({0, 0.1, 0}, {0.1, 0.2, 0.1})),
     block_sites + std::size_t{5 * 5 * 5}},
    {"InsideOut", text_of(inside_out(block)), block_sites},
    {"OneTriangleTurned", text_of(with_one_turned(block)), block_sites},
    {"OverlappingPartsOneInsideOut", text_of(block + inside_out(beside)),
     2 * block_sites - std::size_t{2 * 3 * 5}},
    {"OverlappingParts", text_of(block + beside), 2 * block_sites - std::size_t{2 * 3 * 5}},
    {"OverlappingPartsInsideOut", text_of(inside_out(block + beside)),
     2 * block_sites - std::size_t{2 * 3 * 5}},
    {"APartWithinAPart", text_of(block + box({0.22, 0.06, 0.02}, {0.28, 0.08, 0.08})), block_sites},
    {"ACavity", text_of(block + inside_out(box({0.22, 0.06, 0.02}, {0.28, 0.08, 0.08}))),
     block_sites - std::size_t{3 * 1 * 3}},
    {"PartsThatShareAFace", text_of(block + box({0.3, 0.04, 0}, {0.36, 0.1, 0.1})),
     block_sites + std::size_t{3 * 3 * 5}},
    {"PartsThatShareAFaceInsideOut", text_of(inside_out(block + box({0.3, 0.04, 0}, {0.36, 0.1, 0.1}))),
     block_sites + std::size_t{3 * 3 * 5}},
    {"PartsThatTouchAtAnEdge", text_of(block + box({0.3, 0.1, 0}, {0.36, 0.16, 0.1})),
     block_sites + std::size_t{3 * 3 * 5}},
    {"CornersOffByRounding",
     replaced(text_of(block), "vertex 0.3 0.1 0.1\n  endloop", "vertex 0.30000005 0.1 0.1\n  endloop"),
     block_sites},
    {"Millimetres", text_of(box({200, 40, 0}, {300, 100, 100})), block_sites, "scale = 0.001"},
    {"Moved", text_of(box({0, 0, 0}, {0.1, 0.06, 0.1})), block_sites, "shift = [0.2, 0.04, 0.0]"},
    {"TurnedAboutZ", text_of(box({0.04, -0.3, 0}, {0.1, -0.2, 0.1})), block_sites, "rotate = [0, 0, 90]"},
    {"TurnedAboutY", text_of(box({-0.1, 0.04, 0.2}, {0, 0.1, 0.3})), block_sites, "rotate = [0, 90, 0]"},
    {"ScaledTurnedAndMoved", text_of(box({0, 0, 0}, {60, 100, 100})), block_sites,
     "scale = 0.001, rotate = [0, 0, 90], shift = [0.3, 0.04, 0]"},
    {"Exponents", with_exponents(block), block_sites},
    {"Tabs", replaced(text_of(block), "vertex ", "vertex\t"), block_sites},
    {"WithoutEndsolid", text_of(block).substr(0, text_of(block).find("endsolid")), block_sites},
    {"NameOfTheFormatsWords", text_of(block, "solid facet endsolid"), block_sites},
    {"ColourInTheHeader", binary_of(block, "COLOR=abcd,MATERIAL=efgh"), block_sites},
    {"TrianglesWithoutArea",
     text_of(block + Triangles{{0.2, 0.04, 0, 0.2, 0.04, 0, 0.3, 0.04, 0},
                               {0.2, 0.04, 0, 0.2, 0.04, 0, 0.2, 0.04, 0}}),
     block_sites},
    {"GoingBelowTheFloor", text_of(box({0.2, 0.04, -0.04}, {0.3, 0.1, 0.1})), std::size_t{5 * 3 * 7}},
};

class StlKinds : public ::testing::TestWithParam<Kind> {};

TEST_P(StlKinds, IsReadAndFillsItsSites) {
  const Scene scene(GetParam().bytes, GetParam().keys);
  ASSERT_EQ(scene.errors(), "");
  EXPECT_EQ(scene.sites(), GetParam().sites);
}

INSTANTIATE_TEST_SUITE_P(Stl, StlKinds, ::testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

struct BadKind {
  std::string name;
  std::string bytes;
  std::string error;
  std::string keys = "";
};

Triangles without_last(Triangles triangles, std::size_t count = 1) {
  triangles.resize(triangles.size() - count);
  return triangles;
}

const std::string shape_key = "fluid.obstacle.0.shape: ";

const BadKind bad_kinds[] = {
    {"WithoutAFace", text_of(without_last(block, 2)), shape_key + "the triangles leave a hole"},
    {"WithoutATriangle", binary_of(without_last(block)), shape_key + "the triangles leave a hole"},
    {"EveryTriangleTwice", text_of(block + block), "have the same corners"},
    {"EveryTriangleTwiceAndTurned", text_of(block + inside_out(block)), shape_key + "contains no particle"},
    {"Empty", "", "shape.stl: is neither a text nor a binary STL"},
    {"NoTriangles", "solid nothing\nendsolid nothing\n", "shape.stl: has no triangles"},
    {"BinaryWithoutTriangles", binary_of({}), "shape.stl: has no triangles"},
    {"BinaryThatIsCutOff", binary_of(block).substr(0, 84 + 50 * 5 + 7),
     "shape.stl: is truncated, or not an STL file: it has 5 of 12 triangles"},
    {"BinaryThatCountsTooFew", counting(binary_of(block), 5),
     "shape.stl: its header states 5 triangles, but it has 12"},
    {"BinaryThatCountsTooMany", counting(binary_of(block), 13),
     "shape.stl: is truncated, or not an STL file: it has 12 of 13 triangles"},
    {"BinaryWithoutANumber", binary_of(magnified(block, std::nan(""))), "a corner of triangle 0 is nan"},
    {"BinaryWithoutBounds", binary_of(magnified(block, 1e300)), "a corner of triangle 0 is inf"},
    {"HugeCoordinates", text_of(magnified(block, 1e30)), "sites around it with fluid.spacing = 0.02 m"},
    {"FarFromTheTank", text_of(moved(block, 1000)), shape_key + "lies outside fluid.tank"},
    {"Utf16", "\xFF\xFEs", "shape.stl: is text in UTF-16; save it as UTF-8"},
    {"AVeryLongWord", replaced(text_of(block), "0.04", std::string(100000, 'x')),
     "\"" + std::string(40, 'x') + "...\" in place of a coordinate"},
    {"AnotherFormat", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "shape.stl: is neither a text nor a binary STL"},
    {"TextThatIsCutOff", text_of(block).substr(0, 600), "shape.stl:"},
    {"DecimalCommas", replaced(text_of(block), "0.04", "0,04"), "\"0,04\" in place of a coordinate"},
    {"AQuadrilateral", replaced(text_of(block), "endloop", " vertex 0 0 0\nendloop"),
     "\"vertex\" in place of endloop"},
    {"NotANumber", replaced(text_of(block), "0.04", "nan"), "shape.stl: a corner of triangle 0 is nan"},
    {"SomethingElse", "<?xml version=\"1.0\"?><mesh/>" + std::string(80, ' '),
     "shape.stl: is truncated, or not an STL file"},
    {"InMillimetres", text_of(box({200, 40, 0}, {300, 100, 100})), "set scale = 0.001"},
    {"InMillimetresAtTheOrigin", text_of(box({0, 0, 0}, {100, 60, 100})), "set scale = 0.001"},
    {"BesideTheTank", text_of(box({0.5, 0.04, 0}, {0.6, 0.1, 0.1})),
     shape_key + "lies outside fluid.tank: it reaches from (0.5, 0.04, 0) to (0.6, 0.1, 0.1) m"},
    {"BelowTheTank", text_of(box({0.2, 0.04, -0.2}, {0.3, 0.1, -0.1})),
     shape_key + "lies outside fluid.tank"},
    {"ThinnerThanASpacing", text_of(box({0.205, 0.04, 0}, {0.209, 0.1, 0.1})),
     shape_key + "contains no particle with a spacing of 0.02 m"},
    {"OneAngleInSpace", text_of(block), "rotate has 1 angles, must have 3", "rotate = [90]"},
    {"ScaledByNothing", text_of(block), "scale: 0 must be > 0", "scale = 0"},
};

class BadStlKinds : public ::testing::TestWithParam<BadKind> {};

TEST_P(BadStlKinds, IsRefusedWithWhatIsWrong) {
  EXPECT_THAT(Scene(GetParam().bytes, GetParam().keys).errors(), HasSubstr(GetParam().error));
}

INSTANTIATE_TEST_SUITE_P(Stl, BadStlKinds, ::testing::ValuesIn(bad_kinds),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace cosurge
