// Names beside points of a picture, none over another.
#pragma once

#include "coupler/draw/canvas.hpp"

namespace cosurge {

class Labels {
 public:
  /// Labels stay within `area` as far as there is room.
  Labels(Canvas& canvas, const Rectangle& area) : canvas_(canvas), area_(area) {}

  /// Keeps labels away from a point of the picture.
  void avoid(const Pixel& point);

  /// A name at the nearest free place around `point`, with a line to it where that is not beside it.
  void put(const Pixel& point, const std::string& name, const Color& color);

 private:
  bool is_free(const Rectangle& box) const;

  Canvas& canvas_;
  Rectangle area_;
  std::vector<Rectangle> taken_;
};

}  // namespace cosurge
