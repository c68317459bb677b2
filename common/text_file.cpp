#include "common/text_file.hpp"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

#include "common/error.hpp"

namespace cosurge {

std::string file_contents(const std::filesystem::path& file) {
  std::error_code missing, other;
  require(std::filesystem::exists(file, missing), "{}: no such file{}", file.string(),
          missing ? ": " + missing.message() : "");
  require(std::filesystem::is_regular_file(file, other), "{}: is not a readable file", file.string());
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  const int cause = errno;
  require(in.is_open(), "{}: cannot be read: {}", file.string(), std::generic_category().message(cause));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string without_byte_order_mark(std::string bytes, const std::filesystem::path& file) {
  const bool utf16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
  const bool utf32 = bytes.starts_with(std::string("\0\0\xFE\xFF", 4));
  require(!utf16 && !utf32, "{}: is text in UTF-{}; save it as UTF-8", file.string(), utf32 ? 32 : 16);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '\n' && text[k] != '\r') {
      line += text[k];
      continue;
    }
    if (text[k] == '\r' && k + 1 < text.size() && text[k + 1] == '\n') ++k;
    lines.push_back(line);
    line.clear();
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string clipped(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

}  // namespace cosurge
