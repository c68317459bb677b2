#include "coupler/added_mass_ratio.hpp"

#include <algorithm>

namespace cosurge {

void AddedMassRatio::iterated(const Field& velocity_change, const Field& answer_change) {
  const double square = velocity_change.squaredNorm();
  if (square > 0) value_ = std::max(0.0, -velocity_change.cwiseProduct(answer_change).sum() / square);
}

void AddedMassRatio::passed(const Field& velocity, const Window& window) {
  constexpr double fade = 1 - 1 / memory;
  if (seen_ >= 1) {
    const Field acceleration = (velocity - velocity_) / window.size;
    if (seen_ >= 2) {
      const Field change = acceleration - acceleration_;
      if (seen_ >= 3) {
        product_ = fade * product_ + change.cwiseProduct(change_).sum();
        square_ = fade * square_ + change_.squaredNorm();
        if (square_ > 0) value_ = std::max(0.0, -product_ / square_);
      }
      change_ = change;
    }
    acceleration_ = acceleration;
  }
  velocity_ = velocity;
  seen_ = std::min(seen_ + 1, 3);
}

void AddedMassRatio::save(StateWriter& state) const {
  state.put(value_);
  state.put(seen_);
  state.put(product_);
  state.put(square_);
  for (const Field* field : {&velocity_, &acceleration_, &change_}) put_sized(state, *field);
}

void AddedMassRatio::restore(InterfaceReader& state) {
  state.get(value_);
  state.get(seen_);
  state.get(product_);
  state.get(square_);
  int fields = 0;
  for (Field* field : {&velocity_, &acceleration_, &change_})
    require(state.get_field(*field) == (seen_ > fields++) && seen_ >= 0 && seen_ <= 3,
            "saved state: the added-mass ratio has seen {} windows, and its fields do not fit; it is damaged",
            seen_);
}

}  // namespace cosurge
