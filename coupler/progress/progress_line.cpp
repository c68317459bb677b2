#include "coupler/progress/progress_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace cosurge {
namespace {

constexpr double least_ratio = 0.1;  // least added-mass ratio that is shown

/// A part of the line; the one of the lowest rank is left out last.
struct Part {
  int rank;
  std::string text;
};

/// The parts as they follow each other; empty texts say nothing.
std::vector<Part> parts_of(const ProgressState& s) {
  std::vector<Part> parts = {{0, fmt::format("t {:.4f}/{:g} s", s.time, s.end)}, {2, s.probe}};
  if (s.unconverged > 0) parts.push_back({3, fmt::format("{:.0f} not converged", s.unconverged)});
  if (s.added_mass_ratio >= least_ratio) parts.push_back({4, fmt::format("mu {:.2f}", s.added_mass_ratio)});
  if (s.iterations > 1) parts.push_back({5, fmt::format("iterations {:.0f}", s.iterations)});
  if (!std::isnan(s.max_speed)) parts.push_back({7, fmt::format("speed {:.2f} m/s", s.max_speed)});
  parts.push_back({8, fmt::format("window {}", s.window)});
  parts.push_back({9, fmt::format("dt {:.2e} s", s.window_size)});
  parts.push_back({6, fmt::format("{:.3g} ms/window", 1e3 * s.seconds_per_window)});
  parts.push_back({1, clock_text(s.seconds_left) + " left"});
  std::erase_if(parts, [](const Part& part) { return part.text.empty(); });
  return parts;
}

}  // namespace

std::string clock_text(double seconds) {
  const long whole = std::lround(seconds);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string with_unit(double value, const std::string& unit) {
  constexpr double large = 1e4;
  if (std::isnan(value)) return "- " + unit;
  if (unit == "m" && std::abs(value) < 1) return fmt::format("{:.2f} mm", 1e3 * value);
  if (std::abs(value) >= large) return fmt::format("{:.4g} k{}", 1e-3 * value, unit);
  return fmt::format("{:.4g} {}", value, unit);
}

std::string progress_line(const ProgressState& state, std::size_t width) {
  const std::vector<Part> parts = parts_of(state);
  std::string line;
  for (int most = 0; most <= 9; ++most) {
    std::vector<std::string> texts;
    for (const Part& part : parts)
      if (part.rank <= most) texts.push_back(part.text);
    const std::string longer = fmt::format("{}", fmt::join(texts, "  "));
    if (longer.size() > width) break;
    line = longer;
  }
  return line.empty() ? parts.front().text.substr(0, width) : line;
}

}  // namespace cosurge
