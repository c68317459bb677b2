#include <fmt/ranges.h>

#include "common/case/case_rules.hpp"
#include "common/error.hpp"

namespace cosurge {

void CaseErrors::add(const std::string& key, const std::string& what) {
  if (lines.size() >= most) {
    ++more;
    return;
  }
  std::string around = key;
  while (!places.contains(around) && !around.empty()) {
    const auto dot = around.rfind('.');
    around = dot == std::string::npos ? "" : around.substr(0, dot);
  }
  lines.push_back(fmt::format("{}: {}: {}", places[around], key, what));
}

void CaseErrors::raise() const {
  if (lines.empty()) return;
  throw Error(fmt::format("{}{}", fmt::join(lines, "\n"),
                          more > 0 ? fmt::format("\nand {} more errors", more) : std::string()));
}

}  // namespace cosurge
