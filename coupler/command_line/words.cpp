#include "coupler/command_line/words.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace cosurge {
namespace {

/// Damerau-Levenshtein distance (Damerau 1964): the least number of letters to insert, delete, change or swap
/// with the next one to turn one word into the other.
std::size_t difference(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string unknown_command(const std::vector<std::string>& names, const std::string& word) {
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return difference(word, a) < difference(word, b);
  });
  const bool near = difference(word, *nearest) <= std::max<std::size_t>(1, nearest->size() / 3);
  return fmt::format(
      "cosurge {}: no such command{}. The commands are {}; cosurge COMMAND --help explains one", word,
      near ? fmt::format(", did you mean cosurge {}?", *nearest) : "", fmt::join(names, ", "));
}

}  // namespace cosurge
