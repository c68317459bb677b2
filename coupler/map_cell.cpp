#include "coupler/map_cell.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "coupler/build_id.hpp"
#include "coupler/replace_file.hpp"

namespace cosurge {
namespace {

/// FNV-1a with 64 bits, in hexadecimal.
std::string fingerprint(const std::string& text) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return fmt::format("{:016x}", sum);
}

}  // namespace

MapCell::MapCell(const std::filesystem::path& folder, const std::vector<std::string>& settings)
    : settings_(fmt::format("{}", fmt::join(settings, " "))) {
  std::replace(settings_.begin(), settings_.end(), '\n', ' ');
  path_ = folder / fingerprint(settings_);
}

std::string MapCell::identity(const v1::Case& the_case) {
  return fingerprint(the_case.SerializeAsString() + build_id());
}

bool MapCell::has(const std::string& identity) const {
  return line(0) == settings_ && line(1) == identity && !row().empty();
}

void MapCell::write(const std::string& identity, const std::string& row) const {
  replace_file(path_, {settings_, "\n", identity, "\n", row, "\n"});
}

std::string MapCell::row() const { return line(2); }

std::string MapCell::line(int number) const {
  std::ifstream file(path_);
  std::string line;
  for (int k = 0; k <= number; ++k)
    if (!std::getline(file, line)) return "";
  return line;
}

}  // namespace cosurge
