#include "coupler/report/packing.hpp"

#include <zlib.h>

#include <cstring>
#include <string_view>

#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr int level = 6;  // 9 takes three times as long for 1 % less

template <typename Value>
void planes(std::vector<std::uint8_t>& bytes, std::span<const Value> values) {
  const std::size_t first = bytes.size();
  bytes.resize(first + values.size() * sizeof(Value));
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::uint8_t value[sizeof(Value)];  // little end first: Cosurge is for such machines only
    std::memcpy(value, &values[k], sizeof(Value));
    for (std::size_t b = 0; b < sizeof(Value); ++b) bytes[first + b * values.size() + k] = value[b];
  }
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - k);
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b) group = group << 8 | (b < there ? bytes[k + b] : 0U);
    for (std::size_t letter = 0; letter < 4; ++letter)
      text += letter <= there ? letters[group >> (18 - 6 * letter) & 63] : '=';
  }
  return text;
}

std::string packed(std::span<const std::uint8_t> bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> out(size);
  const int done = compress2(out.data(), &size, bytes.data(), bytes.size(), level);
  require(done == Z_OK, "{} bytes of a report cannot be compressed: zlib says {}", bytes.size(), done);
  return base64({out.data(), size});
}

void append_planes(std::vector<std::uint8_t>& bytes, std::span<const double> values) {
  planes(bytes, values);
}
void append_planes(std::vector<std::uint8_t>& bytes, std::span<const float> values) { planes(bytes, values); }
void append_planes(std::vector<std::uint8_t>& bytes, std::span<const std::uint16_t> values) {
  planes(bytes, values);
}

}  // namespace cosurge
