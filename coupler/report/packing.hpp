// Numbers packed for the page of a report: bytes that zlib makes short, as text. The page's counterpart is
// page/src/unpack.js.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cosurge {

/// A zlib stream of the bytes (RFC 1950), in base64 (RFC 4648).
std::string packed(std::span<const std::uint8_t> bytes);

/// RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

/// Appends the bytes of equal significance of all values together, the lowest first: the high bytes of
/// similar values repeat.
void append_planes(std::vector<std::uint8_t>& bytes, std::span<const double> values);
void append_planes(std::vector<std::uint8_t>& bytes, std::span<const float> values);
void append_planes(std::vector<std::uint8_t>& bytes, std::span<const std::uint16_t> values);

}  // namespace cosurge
