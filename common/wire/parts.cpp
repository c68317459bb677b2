#include "common/wire/parts.hpp"

#include <algorithm>
#include <limits>

#include "common/error.hpp"

namespace cosurge {

bool FrameParts::next(v1::Snapshot& message) {
  std::size_t room = std::max<std::size_t>(1, part_ / sizeof(float));
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

void require_part(const ArrivedPart& part, std::uint64_t particles) {
  constexpr std::uint64_t most_per_particle = 4096, always = std::uint64_t{1} << 28;
  constexpr std::uint64_t most_particles = std::numeric_limits<std::int32_t>::max();  // their ids
  require(part.bytes > 0 || !part.more, "it sends an empty part of a {}, and says that more will follow",
          part.what);
  const std::uint64_t most = always + most_per_particle * std::min(particles, most_particles);
  require(part.before + part.bytes <= most, "its {} exceeds {} bytes, the limit for {} particles", part.what,
          most, particles);
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
