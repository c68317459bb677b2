// A picture in memory: lines, areas, text and particles.
#pragma once

#include <cairo/cairo.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cosurge {

/// Pixels from the upper left corner.
struct Pixel {
  double x;
  double y;
};

/// Red, green, blue and opacity from 0 to 1.
struct Color {
  double red;
  double green;
  double blue;
  double opacity = 1;
};

struct Rectangle {
  double left;
  double top;
  double width;
  double height;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  bool contains(const Pixel& p) const {
    return p.x >= left && p.x <= right() && p.y >= top && p.y <= bottom();
  }
  bool overlaps(const Rectangle& other) const {
    return left < other.right() && other.left < right() && top < other.bottom() && other.top < bottom();
  }
};

struct Stroke {
  Color color;
  double width = 1;                 ///< pixels
  std::vector<double> dashes = {};  ///< lengths of dash and gap; none: solid
};

/// Where a text is relative to its point.
enum class Align { left, center, right };

/// White at the start.
class Canvas {
 public:
  /// @throws Error where there is no memory for it.
  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  void fill(const std::vector<Pixel>& corners, const Color& color);
  void fill(const Rectangle& area, const Color& color);
  /// Slanting lines within a polygon.
  void hatch(const std::vector<Pixel>& corners, const Color& color);
  void line(const std::vector<Pixel>& points, const Stroke& stroke);
  void disc(const Pixel& middle, double radius, const Color& color);

  /// `baseline` of the text; `size` of its letters.
  void text(const Pixel& baseline, const std::string& words, double size, const Color& color,
            Align align = Align::left, bool bold = false);
  double text_width(const std::string& words, double size, bool bold = false) const;

  /// Only what lies within is drawn from here on, until unclip().
  void clip(const Rectangle& area);
  void unclip();

  /// A ball of the radius [pixels], lit from the upper left; `square`: a flat square of that half side.
  /// Much faster than disc(): for many particles.
  void particle(const Pixel& middle, double radius, const Color& color, bool square);

  /// @throws Error where the file cannot be written.
  void save_png(const std::filesystem::path& file) const;

  /// 4 bytes a pixel: blue, green, red, unused; row by row from the top.
  std::span<const std::uint8_t> pixels() const;

 private:
  void use(const Color& color);
  void trace(const std::vector<Pixel>& points);

  int width_;
  int height_;
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
  std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo_;
  Rectangle clip_;
};

}  // namespace cosurge
