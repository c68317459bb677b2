#include "coupler/draw/particles.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {
namespace {

/// A particle as it is drawn.
struct Ball {
  double nearness;
  Pixel at;
  double radius;
  Color color;
};

constexpr double overlap = 1.25;  // size of the balls over the spacing, so that their surface has no gaps
constexpr double farthest_light = 0.72;

void draw_squares(Canvas& canvas, const std::vector<Ball>& balls) {
  for (const Ball& ball : balls) canvas.particle(ball.at, ball.radius, ball.color, true);
}

void draw_balls(Canvas& canvas, std::vector<Ball>& balls) {
  if (balls.empty()) return;
  std::stable_sort(balls.begin(), balls.end(),
                   [](const Ball& a, const Ball& b) { return a.nearness < b.nearness; });
  const double far = balls.front().nearness, depth = std::max(balls.back().nearness - far, 1e-12);
  for (const Ball& ball : balls) {
    const double light = farthest_light + (1 - farthest_light) * (ball.nearness - far) / depth;
    const Color& c = ball.color;
    canvas.particle(ball.at, overlap * ball.radius,
                    {light * c.red, light * c.green, light * c.blue, c.opacity}, false);
  }
}

}  // namespace

void draw_particles(Canvas& canvas, const View& view, const std::vector<Cloud>& clouds) {
  const auto dimension = static_cast<std::size_t>(view.dimension());
  std::vector<Ball> balls;
  Place place(dimension);
  for (const Cloud& cloud : clouds)
    for (std::size_t k = 0; k < cloud.colors.size(); ++k) {
      const auto* const first = cloud.positions.data() + k * dimension;
      std::copy(first, first + dimension, place.begin());
      if (!std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); })) continue;
      balls.push_back({.nearness = view.nearness(place),
                       .at = view.pixel(place),
                       .radius = 0.5 * cloud.spacing * view.pixels_a_metre(),
                       .color = cloud.colors[k]});
    }
  if (dimension == 2)
    draw_squares(canvas, balls);
  else
    draw_balls(canvas, balls);
}

}  // namespace cosurge
