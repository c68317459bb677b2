// The velocity that the water sees first in a window.
#pragma once

#include "common/participant.hpp"
#include "common/state_bytes.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// That of the last window, or linearly extrapolated from the last two.
class Prediction {
 public:
  explicit Prediction(v1::Coupling::Prediction order) : order_(order) {}

  /// For the next window; `velocity` is that of the last one.
  Field next(const Field& velocity, const Window& window) const {
    if (order_ == v1::Coupling::last || size_ == 0 || end_ != window.start) return velocity;
    return velocity + window.size / size_ * (velocity - before_);
  }

  /// A window has passed that began with `velocity`.
  void passed(const Field& velocity, const Window& window) {
    before_ = velocity;
    size_ = window.size;
    end_ = window.start + window.size;
  }

  void save(StateWriter& state) const {
    state.put(size_);
    state.put(end_);
    put_sized(state, before_);
  }
  void restore(StateReader& state) {
    state.get(size_);
    state.get(end_);
    get_sized(state, before_);
  }

 private:
  v1::Coupling::Prediction order_;
  double size_ = 0;  // of the last window [s]
  double end_ = 0;   // of it [s]: nothing is extrapolated over windows that another scheme has gone through
  Field before_;     // velocity of the last window but one
};

}  // namespace cosurge
