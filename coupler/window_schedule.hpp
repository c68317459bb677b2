// When windows begin and end.
#pragma once

#include "common/participant.hpp"
#include "coupler/interface_reader.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// Cuts the time of a case into windows that land exactly on the frames and on the end. What is left before a
/// landing is divided into equal windows, so that no sliver remains; fixed windows are counted, not summed
/// up.
class WindowSchedule {
 public:
  explicit WindowSchedule(const v1::Case& the_case);

  /// The next window, not longer than `largest` [s]; fixed windows do not ask. Does not advance.
  Window next(double largest) const;

  /// The window has been computed.
  void complete(const Window& window);

  void save(StateWriter& state) const;

  /// For a case whose windows, frames and end may have changed.
  /// @throws Error where fixed windows do not reach the time that is restored.
  void restore(InterfaceReader& state);

  double time() const { return time_; }
  std::uint64_t windows() const { return index_; }
  std::uint64_t frames() const { return frames_ + 1; }  ///< so far, with the one at the start
  bool at_frame() const { return at_frame_; }
  bool finished() const { return finished_; }

 private:
  double landing() const;

  v1::Time time_table_;
  double longest_;  // window [s]
  double frame_interval_;
  double time_ = 0;
  std::uint64_t index_ = 0;
  std::int64_t surplus_ = 0;  // windows so far less fixed windows of this case in that time
  std::uint64_t frames_ = 0;  // landings passed
  bool at_frame_ = true;
  bool finished_ = false;
};

}  // namespace cosurge
