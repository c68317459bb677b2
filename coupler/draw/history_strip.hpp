// Histories of one probe over time, with a cursor.
#pragma once

#include "coupler/draw/canvas.hpp"
#include "coupler/results.hpp"

namespace cosurge {

class HistoryStrip {
 public:
  /// Columns of one unit over `time` [s]; `end`: of the axis of time [s].
  HistoryStrip(const std::vector<double>& time, const std::vector<Series>& columns, double end,
               const Rectangle& area);

  /// The curves, the axes, and the cursor at `time` [s].
  void draw(Canvas& canvas, double time) const;

 private:
  Pixel pixel(double time, double value) const;

  Rectangle area_;
  double end_, low_, high_;
  std::string unit_;
  std::vector<std::string> names_;
  std::vector<std::vector<Pixel>> curves_;
};

}  // namespace cosurge
