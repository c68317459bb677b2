#include <fmt/ranges.h>

#include <algorithm>

#include "common/case/case_rules.hpp"
#include "common/error.hpp"

namespace cosurge {

void CaseErrors::add(const std::string& given_key, const std::string& what) {
  const std::string key = written ? written(given_key) : given_key;
  if (lines.size() >= most) {
    ++more;
    return;
  }
  std::string around = key;
  while (!places.contains(around) && !around.empty()) {
    const auto dot = around.rfind('.');
    around = dot == std::string::npos ? "" : around.substr(0, dot);
  }
  const std::string line = fmt::format("{}: {}: {}", places[around], key, written ? written(what) : what);
  if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
}

void CaseErrors::raise() const {
  if (lines.empty()) return;
  throw Error(fmt::format("{}{}", fmt::join(lines, "\n"),
                          more > 0 ? fmt::format("\nand {} more errors", more) : std::string()));
}

}  // namespace cosurge
