#include "common/wire/wire_words.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

}  // namespace

std::string printable(const std::string& words, std::size_t most) {
  const std::size_t end = std::min(words.size(), most);
  std::string text;
  for (std::size_t k = 0; k < end; ++k) {
    const char c = words[k];
    const bool second = k + 1 < end && c == '\xc2' && static_cast<unsigned char>(words[k + 1]) < 0xa0;  // C1
    text.push_back(second || (is_control(c) && c != '\n') ? '?' : c);
    if (second) ++k;
  }
  if (end < words.size()) text.append("...");
  return text;
}

void require_name(const std::string& name, const char* what) {
  constexpr std::size_t longest = 100;
  const bool good = !name.empty() && name.size() <= longest && name != "." && name != ".." &&
                    name.find('/') == std::string::npos && std::none_of(name.begin(), name.end(), is_control);
  require(good, "the name of {} is \"{}\": it must have 1 to {} characters, and no slash", what,
          printable(name, longest), longest);
}

}  // namespace cosurge
