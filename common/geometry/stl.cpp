#include "common/geometry/stl.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "common/error.hpp"
#include "common/text_file.hpp"

namespace cosurge {
namespace {

constexpr std::size_t header = 80, before_triangles = 84, bytes_a_triangle = 50;

void check_finite(const std::vector<double>& corners, const std::string& file) {
  const auto wrong =
      std::find_if_not(corners.begin(), corners.end(), [](double x) { return std::isfinite(x); });
  require(wrong == corners.end(), "{}: a corner of triangle {} is {}, must be finite", file,
          (wrong - corners.begin()) / 9, wrong == corners.end() ? 0 : *wrong);
}

std::uint32_t triangles_of_binary(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= before_triangles) std::memcpy(&count, bytes.data() + header, sizeof count);
  return count;
}

std::vector<double> read_binary(const std::string& bytes, const std::string& file) {
  const std::size_t count = triangles_of_binary(bytes);
  require(bytes.size() >= before_triangles, "{}: is neither a text nor a binary STL", file);
  const std::size_t whole = (bytes.size() - before_triangles) / bytes_a_triangle;
  const std::size_t behind = bytes.size() - before_triangles - std::min(count, whole) * bytes_a_triangle;
  require(behind < bytes_a_triangle || behind % bytes_a_triangle != 0,
          "{}: its header states {} triangles, but it has {}", file, count, whole);
  require(count <= whole, "{}: is truncated, or not an STL file: it has {} of {} triangles", file, whole,
          count);
  std::vector<double> corners;
  for (std::size_t k = 0; k < count; ++k) {
    std::array<float, 12> values{};  // normal, and three corners
    std::memcpy(values.data(), bytes.data() + before_triangles + k * bytes_a_triangle, sizeof values);
    for (std::size_t i = 3; i < values.size(); ++i) corners.push_back(static_cast<double>(values[i]));
  }
  return corners;
}

/// The words of a text STL.
class Text {
 public:
  Text(const std::string& text, std::string file) : file_(std::move(file)), lines_(lines_of(text)) {}

  std::vector<double> read() {
    for (std::string word = next(); !word.empty(); word = next()) {
      if (word == "solid" || word == "endsolid") {
        solid_ = word == "solid";
        skip_line();  // a name
      } else if (!solid_) {
        continue;  // behind the last solid
      } else if (word == "facet") {
        triangle();
      } else {
        refuse("\"" + clipped(word) + "\" in place of facet or endsolid");
      }
    }
    return std::move(corners_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(fmt::format("{}:{}: {}", file_, std::min(line_ + 1, lines_.size()), what));
  }

  /// In small letters; empty at the end.
  std::string next() {
    while (line_ < lines_.size()) {
      const std::string& line = lines_[line_];
      const auto begin = line.find_first_not_of(" \t\v\f", at_);
      if (begin == std::string::npos) {
        skip_line();
        continue;
      }
      at_ = std::min(line.find_first_of(" \t\v\f", begin), line.size());
      std::string word = line.substr(begin, at_ - begin);
      for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return word;
    }
    return "";
  }

  void skip_line() {
    ++line_;
    at_ = 0;
  }

  void expect(const std::string& wanted) {
    const std::string word = next();
    if (word != wanted)
      refuse(word.empty() ? "the file ends within a triangle"
                          : fmt::format("\"{}\" in place of {}", clipped(word), wanted));
  }

  double number() {
    const std::string word = next();
    const std::string plain = word.starts_with("+") ? word.substr(1) : word;
    double value = 0;
    const auto [stop, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (word.empty()) refuse("the file ends within a triangle");
    if (stop != plain.data() + plain.size() || error == std::errc::invalid_argument)
      refuse(fmt::format("\"{}\" in place of a coordinate (numbers have a decimal point)", clipped(word)));
    return error == std::errc::result_out_of_range ? std::strtod(plain.c_str(), nullptr) : value;
  }

  void triangle() {
    expect("normal");
    for (int k = 0; k < 3; ++k) number();  // the order of the corners says it, too
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      for (int k = 0; k < 3; ++k) corners_.push_back(number());
    }
    expect("endloop");
    expect("endfacet");
  }

  std::string file_;
  std::vector<std::string> lines_;
  std::size_t line_ = 0;
  std::size_t at_ = 0;
  bool solid_ = false;
  std::vector<double> corners_;
};

/// Whether the file begins with "solid" and is text, except after "endsolid".
bool is_text(const std::string& bytes) {
  const auto begin = bytes.find_first_not_of(" \t\r\n\v\f");
  if (begin == std::string::npos) return false;
  std::string word = bytes.substr(begin, 5);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word != "solid") return false;
  const auto zero = bytes.find('\0');
  if (zero == std::string::npos) return true;
  std::string text = bytes.substr(0, zero);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text.find("endfacet") != std::string::npos;
}

}  // namespace

std::vector<double> read_stl(const std::filesystem::path& file) {
  const std::string bytes = file_contents(file);
  const std::string name = file.string();
  const bool of_its_size = bytes.size() >= before_triangles &&
                           bytes.size() == before_triangles + triangles_of_binary(bytes) * bytes_a_triangle;
  const std::string text = of_its_size ? "" : without_byte_order_mark(bytes, file);
  std::vector<double> corners = is_text(text) ? Text(text, name).read() : read_binary(bytes, name);
  require(!corners.empty(), "{}: has no triangles", name);
  check_finite(corners, name);
  return corners;
}

}  // namespace cosurge
