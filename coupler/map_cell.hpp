// The row of one cell of a map, kept until the map is complete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// A file with three lines: the settings of the cell, the case and build, the row.
class MapCell {
 public:
  /// `settings`: "key=value" of each key; they name the file in `folder`.
  MapCell(const std::filesystem::path& folder, const std::vector<std::string>& settings);

  /// Everything that a table row depends on: the case with all its values and tables, and the build.
  static std::string identity(const v1::Case& the_case);

  /// Whether the table row of these settings and this identity exists.
  bool has(const std::string& identity) const;

  /// Writes the table row. With an empty identity it is not reused by another map. @throws Error if it cannot
  /// be written.
  void write(const std::string& identity, const std::string& row) const;

  std::string row() const;  ///< empty if there is no row

 private:
  std::string line(int number) const;

  std::filesystem::path path_;
  std::string settings_;
};

}  // namespace cosurge
