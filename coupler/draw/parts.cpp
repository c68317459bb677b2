#include "coupler/draw/parts.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "coupler/draw/colors.hpp"

namespace cosurge {
namespace {

constexpr double probe_radius = 4;
const Color ink = hex(0x1f2937);

/// The kinds in the order in which they are drawn and named.
const std::vector<std::pair<std::string, PartStyle>>& styles() {
  static const std::vector<std::pair<std::string, PartStyle>> all = {
      {"water", {"water at t = 0", {hex(0x2f7fc1), 1.2, {5, 4}}}},
      {"tank", {"tank", {hex(0x4a5260), 2}}},
      {"obstacle", {"obstacle", {hex(0x4a5260), 1.6}, true}},
      {"extreme", {"moving wall at its extremes", {hex(0xd97706), 1.3, {6, 3}}}},
      {"path", {"path of a moving wall", {hex(0xd97706), 1.6}}},
      {"body", {"body", {hex(0xa0522d), 1.4}}},
      {"stairs", {"body on the lattice", {hex(0xdc2626), 1.2}}},
      {"clamp", {"clamp", {hex(0x111827), 1.4}, true}},
      {"support", {"support", {hex(0x7c3aed), 1.4}, true}},
      {"probe", {"probe", {hex(0xbe123c), 2}}}};
  return all;
}

/// A point of a part that has moved: a pose is the place of the origin, then the axes.
Place moved(const std::vector<double>& pose, const Place& x) {
  if (pose.empty()) return x;
  const std::size_t d = x.size();
  Place y(pose.begin(), pose.begin() + static_cast<std::ptrdiff_t>(d));
  for (std::size_t column = 0; column < d; ++column)
    for (std::size_t row = 0; row < d; ++row) y[row] += pose[d + column * d + row] * x[column];
  return y;
}

void draw_probe(Canvas& canvas, const Pixel& at, const Color& color) {
  canvas.disc(at, probe_radius + 1.5, {1, 1, 1});
  canvas.disc(at, probe_radius, color);
  canvas.disc(at, probe_radius - 2.2, {1, 1, 1});
}

void draw_swatch(Canvas& canvas, const std::string& kind, const PartStyle& style, const Pixel& left) {
  const Pixel right{left.x + 24, left.y};
  if (kind == "probe") return draw_probe(canvas, {left.x + 12, left.y}, style.stroke.color);
  if (!style.hatched) return canvas.line({left, right}, style.stroke);
  const std::vector<Pixel> box = {{left.x, left.y - 6},
                                  {right.x, left.y - 6},
                                  {right.x, left.y + 6},
                                  {left.x, left.y + 6},
                                  {left.x, left.y - 6}};
  canvas.hatch(box, style.stroke.color);
  canvas.line(box, style.stroke);
}

}  // namespace

std::vector<Part> read_parts(const nlohmann::ordered_json& outlines) {
  std::vector<Part> parts;
  for (const auto& json : outlines) {
    Part part{.kind = json["kind"], .label = json["label"], .lines = {}, .poses = {}};
    for (const auto& line : json["lines"]) part.lines.push_back(line.get<std::vector<Place>>());
    if (json.contains("poses")) part.poses = json["poses"].get<std::vector<std::vector<double>>>();
    parts.push_back(std::move(part));
  }
  const auto rank = [](const Part& part) {
    return std::find_if(styles().begin(), styles().end(),
                        [&](const auto& style) { return style.first == part.kind; }) -
           styles().begin();
  };
  std::stable_sort(parts.begin(), parts.end(),
                   [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  return parts;
}

const PartStyle& style_of(const std::string& kind) {
  for (const auto& [name, style] : styles())
    if (name == kind) return style;
  return style_of("obstacle");
}

void draw_part(Canvas& canvas, const View& view, const Part& part, std::size_t pose) {
  const PartStyle& style = style_of(part.kind);
  const std::vector<double> placed = part.poses.empty() ? std::vector<double>() : part.poses.at(pose);
  for (const auto& line : part.lines) {
    std::vector<Pixel> points;
    for (const Place& x : line) points.push_back(view.pixel(moved(placed, x)));
    if (part.kind == "probe") {
      draw_probe(canvas, points.front(), style.stroke.color);
      continue;
    }
    if (style.hatched && view.dimension() == 2) canvas.hatch(points, style.stroke.color);
    canvas.line(points, style.stroke);
  }
}

double draw_legend(Canvas& canvas, const std::vector<Part>& parts, const Rectangle& area) {
  constexpr double size = 13, row = 22, gap = 26;
  Pixel at{area.left, area.top + row / 2};
  for (const auto& [kind, style] : styles()) {
    const std::string name = kind;
    if (std::none_of(parts.begin(), parts.end(), [&](const Part& part) { return part.kind == name; }))
      continue;
    const double width = 32 + canvas.text_width(style.name, size);
    if (at.x + width > area.right()) at = {area.left, at.y + row};
    draw_swatch(canvas, kind, style, at);
    canvas.text({at.x + 32, at.y + 4.5}, style.name, size, ink);
    at.x += width + gap;
  }
  return at.y + row / 2;
}

}  // namespace cosurge
