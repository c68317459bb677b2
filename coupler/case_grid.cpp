#include "coupler/case_grid.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge {

std::vector<std::string> split_values(const std::string& text, char at) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{')) ++depth;
    if (!quoted && (c == ']' || c == '}')) --depth;
    if (c == at && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

Axis read_axis(const std::string& text, const std::string& option) {
  const auto equals = text.find('=');
  require(equals != std::string::npos && equals > 0 && equals + 1 < text.size(),
          "{} {}: must be key=value,value,...", option, text);
  Axis axis{.key = text.substr(0, equals), .values = split_values(text.substr(equals + 1), ',')};
  for (const std::string& value : axis.values)
    require(split_values(value, '/').size() == split_values(axis.key, '/').size(),
            "{} {}: {} is not a value for {}", option, text, value, axis.key);
  return axis;
}

std::vector<std::vector<std::string>> combinations(const std::vector<Axis>& axes) {
  std::vector<std::vector<std::string>> grid = {{}};
  for (const Axis& axis : axes) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& cell : grid)
      for (const std::string& value : axis.values) {
        longer.push_back(cell);
        longer.back().push_back(value);
      }
    grid = longer;
  }
  return grid;
}

std::vector<std::string> settings_of(const std::vector<Axis>& axes, const std::vector<std::string>& values) {
  std::vector<std::string> settings;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto keys = split_values(axes[a].key, '/'), parts = split_values(values[a], '/');
    for (std::size_t n = 0; n < keys.size(); ++n) settings.push_back(keys[n] + "=" + parts.at(n));
  }
  return settings;
}

std::string quoted_cell(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
}

std::string cell_of(const std::string& value) {
  return value.find(',') == std::string::npos ? value : quoted_cell(value);
}

}  // namespace cosurge
