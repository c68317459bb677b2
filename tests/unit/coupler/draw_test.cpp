// Pictures: projections, scales, labels, particles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "coupler/draw/axes.hpp"
#include "coupler/draw/color_bar.hpp"
#include "coupler/draw/history_strip.hpp"
#include "coupler/draw/labels.hpp"
#include "coupler/draw/particles.hpp"
#include "coupler/draw/parts.hpp"

namespace cosurge {
namespace {

using ::testing::ElementsAre;

Region region(const Place& min, const Place& max) {
  Region all(static_cast<int>(min.size()));
  all.add(min);
  all.add(max);
  return all;
}

/// Red, green and blue of a pixel.
std::array<int, 3> color_at(const Canvas& canvas, int x, int y) {
  const auto pixels = canvas.pixels();
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width()) +
                              static_cast<std::size_t>(x));
  return {pixels[at + 2], pixels[at + 1], pixels[at]};
}

/// Pixels that are not white within an area.
int drawn(const Canvas& canvas, const Rectangle& area) {
  int count = 0;
  for (int y = static_cast<int>(area.top); y < area.bottom(); ++y)
    for (int x = static_cast<int>(area.left); x < area.right(); ++x)
      count += color_at(canvas, x, y) == std::array<int, 3>{255, 255, 255} ? 0 : 1;
  return count;
}

TEST(View, FitsARegionOfTwoDimensions) {
  const View view(region({0, 0}, {2, 1}), {100, 50, 400, 400});
  EXPECT_DOUBLE_EQ(view.pixels_a_metre(), 200);
  EXPECT_NEAR(view.pixel({0, 0}).x, 100, 1e-9);
  EXPECT_NEAR(view.pixel({2, 0}).x, 500, 1e-9);
  EXPECT_NEAR(view.pixel({1, 0.5}).y, 250, 1e-9);
  EXPECT_GT(view.pixel({0, 0}).y, view.pixel({0, 1}).y) << "up is up";
}

TEST(View, ShowsThreeDimensionsFromTheFrontTheRightAndAbove) {
  const Rectangle area{0, 0, 300, 200};
  const View view(region({0, 0, 0}, {1, 2, 0.5}), area);
  for (const Place& corner : {Place{0, 0, 0}, Place{1, 2, 0.5}, Place{0, 2, 0}, Place{1, 0, 0.5}}) {
    const Pixel at = view.pixel(corner);
    EXPECT_TRUE(at.x >= -1e-9 && at.x <= area.width + 1e-9 && at.y >= -1e-9 && at.y <= area.height + 1e-9);
  }
  EXPECT_GT(view.nearness({0.5, 0, 0}), view.nearness({0.5, 2, 0})) << "the side y = 0 is in front";
  EXPECT_GT(view.nearness({0, 0, 1}), view.nearness({0, 0, 0})) << "seen from above";
}

TEST(Ticks, AreRoundAndNotTooMany) {
  EXPECT_THAT(ticks(0, 1, 5), ElementsAre(0, testing::DoubleEq(0.2), testing::DoubleEq(0.4),
                                          testing::DoubleEq(0.6000000000000001), testing::DoubleEq(0.8), 1));
  for (const double high : {0.0123, 7.0, 4321.0}) {
    EXPECT_LE(ticks(-0.3 * high, high, 6).size(), 7U);
    EXPECT_GE(ticks(-0.3 * high, high, 6).size(), 3U);
  }
}

TEST(Particles, OfTwoDimensionsTouchWithoutGapsOrOverlap) {
  Canvas canvas(60, 40);
  const View view(region({0, 0}, {6, 4}), {0, 0, 60, 40});
  const Color half{0, 0, 1, 0.5};  // an overlap would be darker
  draw_particles(
      canvas, view,
      {{.spacing = 1, .positions = {1.5, 1.5, 2.5, 1.5, 1.5, 2.5, 2.5, 2.5}, .colors = {4, half}}});
  EXPECT_EQ(drawn(canvas, {0, 0, 60, 40}), 400);
  for (int y = 10; y < 30; ++y)
    for (int x = 10; x < 30; ++x)
      EXPECT_EQ(color_at(canvas, x, y), (std::array<int, 3>{128, 128, 255})) << x << ' ' << y;
}

TEST(Particles, OfThreeDimensionsHideThoseBehind) {
  Canvas canvas(100, 100);
  const View view(region({-1, -1, -1}, {1, 1, 1}), {0, 0, 100, 100});
  // On the line to the eye: its direction is the gradient of the nearness.
  const Place zero{0, 0, 0};
  std::vector<float> toward;
  for (const Place& axis : {Place{1, 0, 0}, Place{0, 1, 0}, Place{0, 0, 1}})
    toward.push_back(static_cast<float>(view.nearness(axis) - view.nearness(zero)));
  std::vector<float> positions = toward;
  positions.insert(positions.end(), {0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0});
  draw_particles(canvas, view,
                 {{.spacing = 0.5, .positions = positions, .colors = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}});
  const auto middle = color_at(canvas, 50, 50);
  EXPECT_GT(middle[0], 100);
  EXPECT_EQ(middle[2], 0);
}

TEST(Labels, DoNotLieOnEachOther) {
  Canvas canvas(400, 300);
  Labels labels(canvas, {0, 0, 400, 300});
  for (int k = 0; k < 12; ++k) labels.put({200, 150}, "probe " + std::to_string(k), {0, 0, 0});
  // Twelve labels of more than 45 x 13 pixels each, if none is hidden by another.
  int left = 400, right = 0, top = 300, bottom = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      if (color_at(canvas, x, y)[0] < 100)
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
        bottom = std::max(bottom, y);
  EXPECT_GT((right - left) * (bottom - top), 12 * 45 * 13);
}

TEST(Parts, AreDrawnWhereTheyHaveMoved) {
  const nlohmann::ordered_json outlines = {{{"kind", "tank"},
                                            {"label", "tank"},
                                            {"lines", {{{1, 1}, {1, 3}}}},
                                            {"poses", {{0, 0, 1, 0, 0, 1}, {4, 0, 1, 0, 0, 1}}}}};
  const std::vector<Part> parts = read_parts(outlines);
  const View view(region({0, 0}, {6, 4}), {0, 0, 60, 40});
  Canvas first(60, 40), second(60, 40);
  draw_part(first, view, parts[0], 0);
  draw_part(second, view, parts[0], 1);
  EXPECT_GT(drawn(first, {8, 12, 4, 10}), 0);
  EXPECT_EQ(drawn(first, {40, 0, 20, 40}), 0);
  EXPECT_GT(drawn(second, {48, 12, 4, 10}), 0);
  EXPECT_EQ(drawn(second, {0, 0, 40, 40}), 0);
}

TEST(ColorBar, GivesTheEndsToValuesBeyond) {
  const Shade shade{.name = "pressure", .unit = "Pa", .scale = &viridis, .low = 0, .high = 10};
  EXPECT_EQ(shade.color(-5).red, viridis.front().red);
  EXPECT_EQ(shade.color(50).red, viridis.back().red);
  EXPECT_EQ(shade.color(std::nan("")).red, viridis.front().red);
}

TEST(HistoryStrip, ShowsShortPeaksOfLongHistories) {
  std::vector<double> time, values;
  for (int k = 0; k < 100000; ++k) time.push_back(1e-5 * k), values.push_back(k == 50123 ? 1 : 0);
  Canvas canvas(300, 120);
  HistoryStrip(time, {{.name = "fluid/P", .unit = "Pa", .values = values}}, 1, {50, 20, 200, 80})
      .draw(canvas, 0);
  EXPECT_GT(drawn(canvas, {148, 30, 5, 50}), 20) << "one row of 100 000, in the middle";
}

}  // namespace
}  // namespace cosurge
