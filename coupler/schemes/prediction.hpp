// Prediction of the velocity for the first iteration of a window.
#pragma once

#include <cmath>

#include "common/error.hpp"
#include "common/participant.hpp"
#include "coupler/interface_reader.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// The velocity of the last window, or linearly extrapolated from the last two.
class Prediction {
 public:
  explicit Prediction(v1::Coupling::Prediction order) : order_(order) {}

  /// Prediction for the next window; `velocity` is the velocity of the last one.
  Field next(const Field& velocity, const Window& window) const {
    if (order_ == v1::Coupling::last || size_ == 0 || end_ != window.start) return velocity;
    return velocity + window.size / size_ * (velocity - before_);
  }

  /// Records a window whose first iteration used `velocity`.
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
  void restore(InterfaceReader& state) {
    state.get(size_);
    state.get(end_);
    require(std::isfinite(size_) && std::isfinite(end_) && state.get_field(before_) == (size_ > 0),
            "saved state: the last window has {} s, and its velocity does not fit; it is damaged", size_);
  }

 private:
  v1::Coupling::Prediction order_;
  double size_ = 0;  // size of the last window [s]
  double end_ = 0;   // end of the last window [s]; no extrapolation over windows computed by another scheme
  Field before_;     // velocity of the window before the last one
};

}  // namespace cosurge
