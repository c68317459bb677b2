// When windows begin and end.
#pragma once

#include "common/participant.hpp"
#include "coupler/interface_reader.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// Divides the time of a case into windows that end exactly at the frames and at the end. The remaining time
/// before such an instant is divided into equal windows, so that no very short window remains; fixed windows
/// are counted, not added, to avoid rounding errors.
class WindowSchedule {
 public:
  explicit WindowSchedule(const v1::Case& the_case);

  /// The next window, not longer than `largest` [s], which fixed windows ignore. Does not advance the time.
  Window next(double largest) const;

  /// Call it when the window has been computed.
  void complete(const Window& window);

  void save(StateWriter& state) const;

  /// Restores the state for a case whose windows, frames and end may have changed.
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
  std::int64_t surplus_ = 0;  // windows so far minus the number of fixed windows in that time
  std::uint64_t frames_ = 0;  // instants of frames passed
  bool at_frame_ = true;
  bool finished_ = false;
};

}  // namespace cosurge
