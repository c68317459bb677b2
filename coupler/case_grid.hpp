// Settings of many runs of one case: a grid over values of its keys.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// One direction of a grid. "a/b" with values "1/2" changes several keys together.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// Parts between the characters `at` that are not within brackets or quotes: a vector is one value.
std::vector<std::string> split_values(const std::string& text, char at);

/// Reads "key.path=a,b,c"; `option` is named in errors. @throws Error where it has another form.
Axis read_axis(const std::string& text, const std::string& option = "--over");

/// Every combination of values, the last axis the fastest; one empty combination without axes.
std::vector<std::vector<std::string>> combinations(const std::vector<Axis>& axes);

/// "key=value" of every key, for one combination of values.
std::vector<std::string> settings_of(const std::vector<Axis>& axes, const std::vector<std::string>& values);

/// A text as one cell of a CSV table: in quotes, on one line.
std::string quoted_cell(std::string text);

/// A value as one cell: in quotes where it holds commas.
std::string cell_of(const std::string& value);

}  // namespace cosurge
