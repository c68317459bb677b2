#include "common/wire/parts.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge {

bool FrameParts::next(v1::Snapshot& message) {
  std::size_t room = part_ / sizeof(float);
  while (array_ < frame_.size() && room > 0) {
    const Array& array = frame_[array_];
    const auto components = static_cast<std::size_t>(array.components);
    const std::size_t fitting = std::max<std::size_t>(1, room / components) * components;
    const std::size_t count = std::min(fitting, array.values.size() - value_);
    v1::Array& sent = *message.add_arrays();
    sent.set_name(array.name);
    sent.set_unit(array.unit);
    sent.set_components(static_cast<std::uint32_t>(array.components));
    const auto first = array.values.begin() + static_cast<std::ptrdiff_t>(value_);
    sent.mutable_values()->Assign(first, first + static_cast<std::ptrdiff_t>(count));
    value_ += count;
    room -= std::min(room, count);
    if (value_ < array.values.size()) break;
    ++array_;
    value_ = 0;
  }
  message.set_more(array_ < frame_.size());
  return !message.more();
}

void append(Snapshot&& part, Snapshot& frame) {
  for (Array& array : part) {
    if (frame.empty() || frame.back().name != array.name) {
      frame.push_back(std::move(array));
      continue;
    }
    Array& begun = frame.back();
    require(array.unit == begun.unit && array.components == begun.components,
            "array {} of a frame goes on with {} components in \"{}\" instead of {} in \"{}\"", array.name,
            array.components, array.unit, begun.components, begun.unit);
    begun.values.insert(begun.values.end(), array.values.begin(), array.values.end());
  }
}

}  // namespace cosurge
