#include "common/geometry/crossing_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

namespace cosurge {
namespace {

using Side = Facet<2>;
using Pair = std::pair<std::size_t, std::size_t>;

/// Twice the area of the triangle a b c, negative where it goes around clockwise.
double twice_area(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const Side& s, const Side& t) {
  const auto parted = [](const Side& line, const Side& ends) {
    return twice_area(line[0], line[1], ends[0]) * twice_area(line[0], line[1], ends[1]) < 0;
  };
  return parted(s, t) && parted(t, s);
}

/// Whether two sides lie on each other and go the same way. (The other way they part a hole from the
/// outside.)
bool doubled(const Side& s, const Side& t) {
  const Vec<2> way = s[1] - s[0];
  if (way.dot(t[1] - t[0]) <= 0) return false;
  if (twice_area(s[0], s[1], t[0]) != 0 || twice_area(s[0], s[1], t[1]) != 0) return false;
  return (t[0] - s[0]).dot(way) < way.squaredNorm() && (t[1] - s[0]).dot(way) > 0;
}

double lower(const Side& side, int axis) { return std::min(side[0][axis], side[1][axis]); }
double upper(const Side& side, int axis) { return std::max(side[0][axis], side[1][axis]); }

/// The axis along which sides are shorter.
int axis_of(const std::vector<Side>& sides) {
  Vec<2> lengths = Vec<2>::Zero();
  for (const Side& side : sides) lengths += (side[1] - side[0]).cwiseAbs();
  return lengths[0] <= lengths[1] ? 0 : 1;
}

/// The pair j < i of crossing or doubled sides with the smallest i, then the smallest j.
struct Search {
  std::optional<Pair> found;
  bool given_up = false;
};

/// Goes along an axis and compares each side with those that reach to where it begins.
Search search(const std::vector<Side>& sides) {
  constexpr std::uint64_t most_comparisons = 300'000'000;  // about a second
  const int axis = axis_of(sides), other = 1 - axis;
  std::vector<std::size_t> order(sides.size()), open;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return lower(sides[a], axis) < lower(sides[b], axis); });
  Search result;
  std::uint64_t comparisons = 0;
  for (const std::size_t i : order) {
    const double begin = lower(sides[i], axis);
    std::erase_if(open, [&](std::size_t j) { return upper(sides[j], axis) < begin; });
    comparisons += open.size();
    if (comparisons > most_comparisons) {
      result.given_up = true;
      return result;
    }
    for (const std::size_t j : open) {
      if (upper(sides[j], other) < lower(sides[i], other) || upper(sides[i], other) < lower(sides[j], other))
        continue;
      const Pair pair = {std::max(i, j), std::min(i, j)};
      if (result.found && *result.found <= pair) continue;
      if (cross(sides[pair.first], sides[pair.second]) || doubled(sides[pair.first], sides[pair.second]))
        result.found = pair;
    }
    open.push_back(i);
  }
  return result;
}

}  // namespace

std::string crossing_sides(const std::vector<Side>& sides) {
  const Search result = search(sides);
  if (result.given_up)
    return fmt::format(
        "the polygon has {} sides, most of them very close to each other: too many to check for crossings; "
        "leave out corners that are nearer to each other than the spacing",
        sides.size());
  if (!result.found) return "";
  const auto [i, j] = *result.found;
  if (cross(sides[i], sides[j]))
    return fmt::format("the polygon crosses itself: the sides from corners {} and {} (counted from 0)", j, i);
  return fmt::format(
      "the polygon overlaps itself: the sides from corners {} and {} (counted from 0) lie on each other", j,
      i);
}

}  // namespace cosurge
