// Rules between the keys of a case, checked after each key by itself.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "proto/case.pb.h"

namespace cosurge {

/// The errors of a case, and where each key stands.
struct CaseErrors {
  int dimension = 2;
  std::map<std::string, std::string> places;  ///< key path -> "file:line"
  std::vector<std::string> lines;
  std::size_t more = 0;  ///< errors beyond the lines
  /// Puts keys into a text as the case file has them; empty where they are so already.
  std::function<std::string(const std::string&)> written;

  static constexpr std::size_t most = 100;  ///< largest number of reported errors

  /// Adds "file:line: key: what", with the place of the key or of the nearest table around it; only counts
  /// where there are `most` already. The same line is added once.
  void add(const std::string& key, const std::string& what);

  /// @throws Error with all lines, if there are any.
  void raise() const;
};

/// Boxes divided by their spacing, bodies and water inside the tank and apart from each other, outlines
/// closed; probes on their bodies; times that fit.
void check_rules(const v1::Case& the_case, CaseErrors& errors);

}  // namespace cosurge
