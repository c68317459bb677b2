#include "common/case/toml_bounds.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge {
namespace {

/// Behind the text in quotes that begins at `at`; a text of one line ends with its line at the latest.
std::size_t behind_quotes(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool lines = text.substr(at).starts_with(three);
  const bool escapes = quote == '"';
  for (at += lines ? 3 : 1; at < text.size(); ++at) {
    if (escapes && text[at] == '\\')
      ++at;
    else if (lines && text.substr(at).starts_with(three))
      return at + 3;
    else if (!lines && (text[at] == quote || text[at] == '\n'))
      return at + (text[at] == quote ? 1 : 0);
  }
  return text.size();
}

/// Calls `visit(character, line)` for all that is neither in quotes nor in a comment.
template <typename Visit>
void walk(std::string_view text, Visit visit) {
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      const std::size_t end = behind_quotes(text, at);
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                  text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      at = end;
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else {
      visit(c, line);
      line += c == '\n' ? 1 : 0;
      ++at;
    }
  }
}

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

}  // namespace

void require_short_keys(std::string_view text, const std::string& source) {
  std::size_t parts = 1;
  walk(text, [&](char c, std::size_t line) {
    if (c == '.') ++parts;
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) parts = 1;
    require(parts <= most_key_parts, "{}:{}: a key has more than {} parts", source, line, most_key_parts);
  });
}

void require_ascii(std::string_view text, const std::string& source) {
  walk(text, [&](char c, std::size_t line) {
    require(is_ascii(c),
            "{}:{}: a letter or blank that is not ASCII, which is allowed in quotes and comments only",
            source, line);
  });
}

}  // namespace cosurge
