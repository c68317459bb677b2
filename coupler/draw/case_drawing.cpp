#include "coupler/draw/case_drawing.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/case/bodies.hpp"
#include "coupler/draw/axes.hpp"
#include "coupler/draw/colors.hpp"
#include "coupler/draw/labels.hpp"
#include "coupler/draw/parts.hpp"
#include "coupler/draw/scene_clouds.hpp"
#include "coupler/report/outlines.hpp"

namespace cosurge {
namespace {

constexpr int width = 1100, least_width = 720;
constexpr double left = 62, right = 24, title_height = 52, between = 78, below_axes = 48, legend_height = 60;
constexpr double highest = 620, lowest = 170;  // limits of the height of a panel [pixels]
constexpr double small = 0.4;  // size of the bodies over that of the scene, below which they get a panel
constexpr double flat = 0.45;  // height over width, below which panels stand one above the other
const Color ink = hex(0x111827), water_color = hex(0x8fc1ea), body_color = hex(0xf0a35e);

/// What both panels show.
struct Drawing {
  std::vector<Part> parts;
  std::vector<Cloud> clouds;
};

/// A region of the scene and its area in the picture.
struct Panel {
  Region region;
  Rectangle area;
};

Drawing drawing_of(const v1::Case& the_case, const FrameSource& fluid, const FrameSource& solid) {
  constexpr double unlimited = 1e9;
  Drawing drawing{.parts = read_parts(outlines_of_check(the_case)), .clouds = {}};
  for (const Cast& cast : choose(the_case, fluid, solid, 1, unlimited).casts) {
    const bool is_fluid = cast.member == "fluid";
    const ShownFrame shown = read_shown(is_fluid ? fluid : solid, cast, 0);
    Cloud cloud{.spacing = is_fluid ? the_case.fluid().spacing() : solid_spacing(the_case),
                .positions = shown.positions,
                .colors = {}};
    for (const Kind kind : shown.kinds)
      cloud.colors.push_back(!is_fluid ? body_color : kind == Kind::water ? water_color : wall_color(kind));
    drawing.clouds.push_back(std::move(cloud));
  }
  return drawing;
}

/// The region of the parts of a kind; of all parts without a kind.
Region region_of(const std::vector<Part>& parts, int dimension, const std::string& kind = "") {
  Region region(dimension);
  for (const Part& part : parts)
    for (const auto& line : part.lines)
      for (const Place& place : line)
        if (kind.empty() || part.kind == kind) region.add(place);
  return region;
}

/// Where the bodies are, if they are small in the scene.
std::optional<Region> detail_of(const Drawing& drawing, const Region& scene, int dimension) {
  const Region bodies = region_of(drawing.parts, dimension, "body");
  if (bodies.empty() || bodies.largest_size() > small * scene.largest_size()) return std::nullopt;
  return bodies.grown(0.3 * bodies.largest_size());
}

/// One panel, or two: side by side, or one above the other if the scene is long.
std::vector<Panel> layout(const Region& scene, const std::optional<Region>& detail) {
  const auto fit = [](const Region& region, double x, double y, double wide, double high) {
    const double aspect = View::aspect(region);
    const double height = std::clamp(wide * aspect, lowest, high);
    return Rectangle{x, y, std::min(wide, std::max(height / aspect, 260.0)), height};
  };
  const double whole = width - left - right;
  if (!detail) return {{scene, fit(scene, left, title_height, whole, highest)}};
  if (View::aspect(scene) < flat) {
    const Rectangle first = fit(scene, left, title_height, whole, highest / 2);
    return {{scene, first}, {*detail, fit(*detail, left, first.bottom() + between, whole, highest / 1.5)}};
  }
  const double half = (whole - between) / 2;
  const Rectangle first = fit(scene, left, title_height, half, highest);
  return {{scene, first}, {*detail, fit(*detail, first.right() + between, title_height, half, highest)}};
}

/// Whether a part is named in the picture.
bool is_named(const Part& part, const std::vector<Part>& parts) {
  if (part.kind == "probe" || part.kind == "extreme" || part.kind == "support") return true;
  if (part.kind != "body" && part.kind != "obstacle") return false;
  return std::count_if(parts.begin(), parts.end(),
                       [&](const Part& other) { return other.kind == part.kind; }) > 1;
}

/// Names the parts in a panel, except those that the enlarged panel shows.
void draw_names(Canvas& canvas, const View& view, const std::vector<Part>& parts, const Rectangle& larger) {
  Labels labels(canvas, view.area());
  std::vector<std::pair<Pixel, const Part*>> named;
  for (const Part& part : parts) {
    if (part.lines.empty() || part.lines.front().empty() || !is_named(part, parts)) continue;
    const Pixel at = view.pixel(part.lines.front().front());
    if (!view.area().contains(at) || larger.contains(at)) continue;
    named.emplace_back(at, &part);
    labels.avoid(at);
  }
  for (const auto& [at, part] : named) {
    const auto end = part->label.find(" at t = 0");
    const std::string name =
        end != std::string::npos && part->kind == "body" ? part->label.substr(0, end) : part->label;
    labels.put(at, name, style_of(part->kind).stroke.color);
  }
}

void draw_panel(Canvas& canvas, const View& view, const Drawing& drawing) {
  canvas.clip(view.area());
  draw_particles(canvas, view, drawing.clouds);
  for (const Part& part : drawing.parts) draw_part(canvas, view, part);
  canvas.unclip();
  if (view.dimension() == 2)
    draw_axes(canvas, view);
  else
    draw_directions(canvas, view);
}

/// Where a region appears in another view: what it covers at most.
Rectangle seen_in(const View& view, const Region& region) {
  std::vector<double> x, y;
  const std::size_t dimension = region.min.size();
  for (unsigned corner = 0; corner < 1U << dimension; ++corner) {
    Place place;
    for (std::size_t axis = 0; axis < dimension; ++axis)
      place.push_back(corner >> axis & 1U ? region.max[axis] : region.min[axis]);
    x.push_back(view.pixel(place).x);
    y.push_back(view.pixel(place).y);
  }
  const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
  const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
  return {*x0, *y0, *x1 - *x0, *y1 - *y0};
}

void frame_detail(Canvas& canvas, const Rectangle& box) {
  canvas.line({{box.left, box.top},
               {box.right(), box.top},
               {box.right(), box.bottom()},
               {box.left, box.bottom()},
               {box.left, box.top}},
              {.color = ink, .width = 1, .dashes = {2, 3}});
}

}  // namespace

void draw_case(const std::filesystem::path& file, const v1::Case& the_case, const FrameSource& fluid,
               const FrameSource& solid) {
  const int dimension = the_case.dimension();
  const Drawing drawing = drawing_of(the_case, fluid, solid);
  const Region tight = region_of(drawing.parts, dimension);
  const double spacing = the_case.has_fluid() ? the_case.fluid().spacing() : solid_spacing(the_case);
  const Region scene = tight.grown(std::max(0.02 * tight.largest_size(), 3.5 * spacing));
  const auto panels = layout(scene, detail_of(drawing, scene, dimension));
  double bottom = 0, end = least_width - right;
  for (const Panel& panel : panels)
    bottom = std::max(bottom, panel.area.bottom()), end = std::max(end, panel.area.right());
  Canvas canvas(static_cast<int>(end + right), static_cast<int>(bottom + below_axes + legend_height));
  canvas.text({left, 28}, the_case.title(), 18, ink, Align::left, true);
  std::vector<View> views;
  for (const Panel& panel : panels) views.emplace_back(panel.region, panel.area);
  for (const View& view : views) draw_panel(canvas, view, drawing);
  const Rectangle larger = views.size() > 1 ? seen_in(views[0], panels[1].region) : Rectangle{-1, -1, 0, 0};
  if (views.size() > 1) frame_detail(canvas, larger);
  for (std::size_t k = 0; k < views.size(); ++k)
    draw_names(canvas, views[k], drawing.parts, k == 0 ? larger : Rectangle{-1, -1, 0, 0});
  draw_legend(canvas, drawing.parts, {left, bottom + below_axes, end - left, legend_height});
  canvas.save_png(file);
}

}  // namespace cosurge
