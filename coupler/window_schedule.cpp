#include "coupler/window_schedule.hpp"

#include <algorithm>
#include <cmath>

namespace cosurge {
namespace {

constexpr double rounding = 1e-9;  // of a window: how far times may be off by the rounding of sums

}  // namespace

WindowSchedule::WindowSchedule(const v1::Case& the_case)
    : time_table_(the_case.time()), frame_interval_(the_case.output().frame_interval()) {}

double WindowSchedule::landing() const {
  return std::min(time_table_.end(), static_cast<double>(frames_ + 1) * frame_interval_);
}

Window WindowSchedule::next(double largest) const {
  const double size = time_table_.window();
  if (time_table_.stepping() == v1::Time::fixed)
    return {.index = index_, .start = static_cast<double>(index_) * size, .size = size};
  const double left = landing() - time_;
  const double parts = std::max(1.0, std::ceil(left / std::min(size, largest) - rounding));
  return {.index = index_, .start = time_, .size = left / parts};
}

void WindowSchedule::complete(const Window& window) {
  ++index_;
  time_ = window.start + window.size;
  at_frame_ = time_ > landing() - rounding * window.size;
  if (!at_frame_) return;
  time_ = landing();
  finished_ = time_ >= time_table_.end();
  ++frames_;
}

void WindowSchedule::save(StateWriter& state) const {
  state.put(time_);
  state.put(index_);
  state.put(frames_);
  state.put(at_frame_);
  state.put(finished_);
}

void WindowSchedule::restore(StateReader& state) {
  state.get(time_);
  state.get(index_);
  state.get(frames_);
  state.get(at_frame_);
  state.get(finished_);
}

}  // namespace cosurge
