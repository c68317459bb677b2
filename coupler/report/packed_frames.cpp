#include "coupler/report/packed_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/report/packing.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

constexpr std::uint8_t lost = 5;  // the kind of the frames
constexpr double most_words = 65535;
constexpr double most_bytes = 255;

/// Least and largest of the values that are numbers.
struct Range {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void add(double value) {
    if (!std::isfinite(value)) return;
    min = std::min(min, value);
    max = std::max(max, value);
  }
  double length() const { return max > min ? max - min : 0; }
  double start() const { return min <= max ? min : 0; }
};

/// The displayed values of one frame.
struct Shown {
  std::vector<std::vector<float>> position;  // by coordinate
  Bytes kind;
  std::vector<std::vector<float>> quantity;
};

std::vector<float> picked(const std::vector<float>& all, const std::vector<std::size_t>& particles,
                          std::size_t components, std::size_t component) {
  std::vector<float> values;
  values.reserve(particles.size());
  for (const std::size_t k : particles) values.push_back(all[k * components + component]);
  return values;
}

std::vector<float> speeds(const FrameSource& source, const Cast& cast, std::size_t frame) {
  const std::vector<float> velocity = source.read("velocity", frame);
  const auto components = static_cast<std::size_t>(source.components("velocity"));
  std::vector<float> values;
  values.reserve(cast.particles.size());
  for (const std::size_t k : cast.particles) {
    double square = 0;
    for (std::size_t c = 0; c < components; ++c) {
      const double v = velocity[k * components + c];
      square += v * v;
    }
    values.push_back(static_cast<float>(std::sqrt(square)));
  }
  return values;
}

Shown shown(const FrameSource& source, const Cast& cast, std::size_t frame) {
  Shown out;
  const std::vector<float> position = source.read("position", frame);
  const auto components = static_cast<std::size_t>(source.components("position"));
  for (std::size_t c = 0; c < components; ++c)
    out.position.push_back(picked(position, cast.particles, components, c));
  out.kind.assign(cast.particles.size(), 0);
  if (source.has("kind")) {
    const std::vector<float> kind = picked(source.read("kind", frame), cast.particles, 1, 0);
    std::transform(kind.begin(), kind.end(), out.kind.begin(),
                   [](float k) { return static_cast<std::uint8_t>(k); });
  }
  for (const auto& x : out.position)
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!std::isfinite(x[k])) out.kind[k] = lost;
  for (const std::string& name : cast.quantities)
    out.quantity.push_back(name == "speed" ? speeds(source, cast, frame)
                                           : picked(source.read(name, frame), cast.particles, 1, 0));
  return out;
}

/// Positions on the grid of 16 bits; those of lost particles at its origin.
Words on_grid(const Shown& frame, std::size_t axis, double origin, double step) {
  Words words(frame.kind.size(), 0);
  for (std::size_t k = 0; k < words.size(); ++k)
    if (frame.kind[k] != lost)
      words[k] = static_cast<std::uint16_t>(
          std::clamp(std::round((frame.position[axis][k] - origin) / step), 0.0, most_words));
  return words;
}

Bytes on_scale(const std::vector<float>& values, const Range& range) {
  Bytes bytes(values.size(), 0);
  if (range.length() == 0) return bytes;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::isfinite(values[k]))
      bytes[k] = static_cast<std::uint8_t>(
          std::round(most_bytes * std::sqrt((values[k] - range.min) / range.length())));
  return bytes;
}

/// Differences of 16 bits, with the sign in the lowest: small ones of both signs have a high byte of zero.
Words signed_last(const Words& now, const Words& foretold) {
  Words out(now.size());
  for (std::size_t k = 0; k < now.size(); ++k) {
    const auto d = static_cast<std::int16_t>(now[k] - foretold[k]);
    out[k] =
        static_cast<std::uint16_t>(static_cast<std::uint16_t>(d << 1) ^ static_cast<std::uint16_t>(d >> 15));
  }
  return out;
}

/// Extrapolation from the frames before: nothing for the first, rest for the second, then even motion.
class Forecast {
 public:
  Words of(std::size_t axis, std::size_t particles) const {
    if (last_.size() <= axis) return Words(particles, 0);
    Words out = last_[axis];
    if (before_.size() > axis)
      for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = static_cast<std::uint16_t>(2 * out[k] - before_[axis][k]);
    return out;
  }
  void next(std::vector<Words> now) {
    before_ = std::move(last_);
    last_ = std::move(now);
  }

 private:
  std::vector<Words> last_, before_;
};

void append_differences(Bytes& out, const Bytes& now, Bytes& before) {
  before.resize(now.size(), 0);
  for (std::size_t k = 0; k < now.size(); ++k) out.push_back(static_cast<std::uint8_t>(now[k] - before[k]));
  before = now;
}

/// Box around all that is not lost, and ranges of the quantities.
struct Scales {
  std::vector<Range> box, quantity;
  double step = 1;

  Scales(const std::vector<Shown>& frames, double finest) : box(frames.front().position.size()) {
    quantity.resize(frames.front().quantity.size());
    for (const Shown& frame : frames) {
      for (std::size_t k = 0; k < frame.kind.size(); ++k) {
        if (frame.kind[k] == lost) continue;
        for (std::size_t axis = 0; axis < box.size(); ++axis) box[axis].add(frame.position[axis][k]);
        for (std::size_t q = 0; q < quantity.size(); ++q) quantity[q].add(frame.quantity[q][k]);
      }
    }
    double longest = 0;
    for (const Range& side : box) longest = std::max(longest, side.length());
    if (longest > 0) step = std::max(longest / most_words, finest);
  }
};

Bytes bytes_of(const std::vector<Shown>& frames, const Scales& scales, bool kinds) {
  Bytes bytes, kind;
  std::vector<Bytes> quantity(scales.quantity.size());
  Forecast forecast;
  for (const Shown& frame : frames) {
    std::vector<Words> now;
    for (std::size_t axis = 0; axis < scales.box.size(); ++axis) {
      now.push_back(on_grid(frame, axis, scales.box[axis].start(), scales.step));
      append_planes(bytes, signed_last(now.back(), forecast.of(axis, now.back().size())));
    }
    forecast.next(std::move(now));
    if (kinds) append_differences(bytes, frame.kind, kind);
    for (std::size_t q = 0; q < quantity.size(); ++q)
      append_differences(bytes, on_scale(frame.quantity[q], scales.quantity[q]), quantity[q]);
  }
  return bytes;
}

}  // namespace

Json pack_frames(const FrameSource& source, const Cast& cast, const std::vector<std::size_t>& frames) {
  std::vector<Shown> all;
  for (const std::size_t frame : frames) all.push_back(shown(source, cast, frame));
  const Scales scales(all, cast.finest);
  Json origin = Json::array(), quantities = Json::array();
  for (const Range& side : scales.box) origin.push_back(side.start());
  for (std::size_t q = 0; q < cast.quantities.size(); ++q) {
    const std::string& name = cast.quantities[q];
    const Range& range = scales.quantity[q];
    quantities.push_back({{"name", name},
                          {"unit", source.unit(name == "speed" ? "velocity" : name)},
                          {"min", range.start()},
                          {"max", range.start() + range.length()}});
  }
  const bool kinds = source.has("kind");
  return {{"member", cast.member},
          {"particles", cast.particles.size()},
          {"origin", origin},
          {"step", scales.step},
          {"components", scales.box.size()},
          {"kinds", kinds},
          {"quantities", quantities},
          {"frames", frames.size()},
          {"data", packed(bytes_of(all, scales, kinds))}};
}

}  // namespace cosurge
