// States and frames that are too large for one message travel in parts (docs/protocol.md).
#pragma once

#include <cstdint>
#include <string>

#include "common/participant.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {

/// Largest part [bytes]: a quarter of a message, so that it passes within a heartbeat on a slow network, too.
inline constexpr std::size_t part_bytes = std::size_t{1} << 26;

/// Gives out a state part by part.
class StateParts {
 public:
  explicit StateParts(std::string state, std::size_t part = part_bytes)
      : state_(std::move(state)), part_(part) {}

  /// Fills the next part, of a message that has `state` and `more`. Returns whether it was the last one.
  template <typename Message>
  bool next(Message& message) {
    const bool whole = given_ == 0 && state_.size() <= part_;
    if (whole)
      message.set_state(std::move(state_));
    else
      message.set_state(state_.substr(given_, part_));
    given_ += part_;
    message.set_more(!whole && given_ < state_.size());
    return !message.more();
  }

 private:
  std::string state_;
  std::size_t part_;
  std::size_t given_ = 0;
};

/// Gives out a frame part by part: arrays in their order, the last one of a part goes on in the next part.
class FrameParts {
 public:
  explicit FrameParts(Snapshot frame, std::size_t part = part_bytes)
      : frame_(std::move(frame)), part_(part) {}

  /// Fills the next part. Returns whether it was the last one.
  bool next(v1::Snapshot& message);

 private:
  Snapshot frame_;
  std::size_t part_;
  std::size_t array_ = 0;  // the next one to give out, from this value on
  std::size_t value_ = 0;
};

/// A part that has arrived.
struct ArrivedPart {
  const char* what;    ///< "state" or "frame"
  std::size_t bytes;   ///< of it
  std::size_t before;  ///< of the parts before it
  bool more;           ///< whether the sender says that more will follow
};

/// @throws Error for an empty part before others, and if all of them exceed what so many particles need.
void require_part(const ArrivedPart& part, std::uint64_t particles);

/// Adds a part of a frame to those before it.
/// @throws Error where an array goes on with another unit or number of components.
void append(Snapshot&& part, Snapshot& frame);

}  // namespace cosurge
