#include "coupler/window_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "common/case/window_sizes.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr double rounding_of_quotient = 1e-12;
constexpr double rounding = 1e-9;  // tolerance for rounded sums of times [windows]

}  // namespace

WindowSchedule::WindowSchedule(const v1::Case& the_case)
    : time_table_(the_case.time()),
      longest_(longest_window(the_case)),
      frame_interval_(the_case.output().frame_interval()) {}

double WindowSchedule::landing() const {
  // The time is exactly that of a frame or between two; the end of an earlier case may lie between two.
  const double passed = std::floor(time_ / frame_interval_ + rounding_of_quotient);
  const double frame = (passed + 1) * frame_interval_, end = time_table_.end();
  // Rounding: five times 0.09 is less than 0.45 in binary; this remainder is not a window.
  return frame < end - rounding_of_quotient * end ? frame : end;
}

Window WindowSchedule::next(double largest) const {
  const double size = longest_;
  if (time_table_.stepping() == v1::Time::fixed)
    return {.index = index_,
            .start = static_cast<double>(static_cast<std::int64_t>(index_) - surplus_) * size,
            .size = size};
  const double left = landing() - time_;
  const double parts = std::max(1.0, std::ceil(left / std::min(size, largest) - rounding));
  return {.index = index_, .start = time_, .size = left / parts};
}

void WindowSchedule::complete(const Window& window) {
  const double next = landing();
  ++index_;
  time_ = window.start + window.size;
  at_frame_ = time_ > next - rounding * window.size;
  if (!at_frame_) return;
  time_ = next;
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

void WindowSchedule::restore(InterfaceReader& state) {
  state.get(time_);
  state.get(index_);
  state.get(frames_);
  state.get(at_frame_);
  state.get(finished_);
  constexpr double most = 9007199254740992.0;  // 2^53: a double holds no larger number of windows exactly
  require(time_ >= 0 && time_ < most * longest_ && index_ < static_cast<std::uint64_t>(most),
          "saved state: t = {} s after {} windows; it is damaged", time_, index_);
  finished_ = time_ >= time_table_.end();
  if (time_table_.stepping() != v1::Time::fixed) return;
  const double size = longest_, windows = std::round(time_ / size);
  require(std::abs(windows - time_ / size) < 1e-6,
          "time.window: the time reached, t = {:.9g} s, is not a whole number of fixed windows of {} s",
          time_, size);
  surplus_ = static_cast<std::int64_t>(index_) - static_cast<std::int64_t>(windows);
}

}  // namespace cosurge
