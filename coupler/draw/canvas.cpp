#include "coupler/draw/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.hpp"

namespace cosurge {
namespace {

void set_font(cairo_t* cairo, double size, bool bold) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

/// One colour over another.
std::uint8_t blend(std::uint8_t below, double above, double opacity) {
  return static_cast<std::uint8_t>(
      std::lround(below + opacity * (255 * std::clamp(above, 0.0, 1.0) - below)));
}

}  // namespace

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy),
      clip_{0, 0, static_cast<double>(width), static_cast<double>(height)} {
  require(cairo_status(cairo_.get()) == CAIRO_STATUS_SUCCESS,
          "a picture of {} x {} pixels cannot be made: {}", width, height,
          cairo_status_to_string(cairo_status(cairo_.get())));
  fill(clip_, {1, 1, 1});
}

void Canvas::use(const Color& color) {
  cairo_set_source_rgba(cairo_.get(), color.red, color.green, color.blue, color.opacity);
}

void Canvas::trace(const std::vector<Pixel>& points) {
  cairo_new_path(cairo_.get());
  for (const Pixel& p : points) cairo_line_to(cairo_.get(), p.x, p.y);
}

void Canvas::fill(const std::vector<Pixel>& corners, const Color& color) {
  use(color);
  trace(corners);
  cairo_fill(cairo_.get());
}

void Canvas::fill(const Rectangle& area, const Color& color) {
  use(color);
  cairo_rectangle(cairo_.get(), area.left, area.top, area.width, area.height);
  cairo_fill(cairo_.get());
}

void Canvas::hatch(const std::vector<Pixel>& corners, const Color& color) {
  constexpr double distance = 6;
  if (corners.size() < 3) return;
  double left = corners[0].x, right = left, top = corners[0].y, bottom = top;
  for (const Pixel& p : corners) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  left = std::max(left, clip_.left), right = std::min(right, clip_.right());
  top = std::max(top, clip_.top), bottom = std::min(bottom, clip_.bottom());
  cairo_save(cairo_.get());
  trace(corners);
  cairo_clip(cairo_.get());
  const double height = bottom - top;
  for (double x = left - height; x < right; x += distance)
    line({{x, bottom}, {x + height, top}}, {.color = color});
  cairo_restore(cairo_.get());
}

void Canvas::line(const std::vector<Pixel>& points, const Stroke& stroke) {
  use(stroke.color);
  cairo_set_line_width(cairo_.get(), stroke.width);
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(cairo_.get(), stroke.dashes.data(), static_cast<int>(stroke.dashes.size()), 0);
  trace(points);
  cairo_stroke(cairo_.get());
}

void Canvas::disc(const Pixel& middle, double radius, const Color& color) {
  use(color);
  cairo_new_path(cairo_.get());
  cairo_arc(cairo_.get(), middle.x, middle.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(cairo_.get());
}

void Canvas::text(const Pixel& baseline, const std::string& words, double size, const Color& color,
                  Align align, bool bold) {
  set_font(cairo_.get(), size, bold);
  use(color);
  const double width = align == Align::left ? 0 : text_width(words, size, bold);
  cairo_move_to(cairo_.get(), baseline.x - (align == Align::center ? width / 2 : width), baseline.y);
  cairo_show_text(cairo_.get(), words.c_str());
}

double Canvas::text_width(const std::string& words, double size, bool bold) const {
  set_font(cairo_.get(), size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_.get(), words.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::clip(const Rectangle& area) {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), area.left, area.top, area.width, area.height);
  cairo_clip(cairo_.get());
  clip_ = area;
}

void Canvas::unclip() {
  cairo_restore(cairo_.get());
  clip_ = {0, 0, static_cast<double>(width_), static_cast<double>(height_)};
}

void Canvas::particle(const Pixel& middle, double radius, const Color& color, bool square) {
  cairo_surface_flush(surface_.get());
  std::uint8_t* const data = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  // Pixels whose middle is within the reach. Squares that touch leave no line of pixels between them.
  constexpr double rounding = 0.01;
  const double reach = square ? radius + rounding : radius + 0.5;
  const auto begin = [&](double at, double least) {
    return static_cast<int>(std::ceil(std::max(at - reach - 0.5, least)));
  };
  const auto end = [&](double at, double most) {
    return static_cast<int>(std::ceil(std::min(at + reach - 0.5, most)));
  };
  const int y_end = end(middle.y, clip_.bottom()), x_end = end(middle.x, clip_.right());
  for (int y = begin(middle.y, clip_.top); y < y_end; ++y) {
    for (int x = begin(middle.x, clip_.left); x < x_end; ++x) {
      const double dx = (x + 0.5 - middle.x) / radius, dy = (y + 0.5 - middle.y) / radius,
                   r = std::hypot(dx, dy);
      double opacity = color.opacity, light = 1;
      if (!square) {
        opacity *= std::clamp((1 - r) * radius + 0.5, 0.0, 1.0);
        const double front = std::sqrt(std::max(0.0, 1 - r * r));
        light = 0.62 + 0.38 * std::max(0.0, 0.75 * front - 0.4 * dx - 0.55 * dy);
      }
      std::uint8_t* const p = data + static_cast<std::ptrdiff_t>(y) * stride + std::ptrdiff_t{4} * x;
      p[0] = blend(p[0], light * color.blue, opacity);
      p[1] = blend(p[1], light * color.green, opacity);
      p[2] = blend(p[2], light * color.red, opacity);
    }
  }
  cairo_surface_mark_dirty(surface_.get());
}

void Canvas::save_png(const std::filesystem::path& file) const {
  const cairo_status_t status = cairo_surface_write_to_png(surface_.get(), file.c_str());
  require(status == CAIRO_STATUS_SUCCESS, "{}: cannot be written: {}", file.string(),
          cairo_status_to_string(status));
}

std::span<const std::uint8_t> Canvas::pixels() const {
  cairo_surface_flush(surface_.get());
  const auto rows = static_cast<std::size_t>(height_);
  return {cairo_image_surface_get_data(surface_.get()),
          rows * static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()))};
}

}  // namespace cosurge
