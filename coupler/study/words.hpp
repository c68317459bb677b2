// Common code for reading the options of a study.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace cosurge {

std::string without_blanks(std::string text);

/// The finite number that the whole text represents; nothing otherwise.
std::optional<double> number_of(const std::string& text);

/// Calls `read` and appends the message of what it throws to `wrong`, each message once.
template <typename Read>
void note_errors(std::vector<std::string>& wrong, const Read& read) {
  try {
    read();
  } catch (const std::exception& error) {
    if (std::find(wrong.begin(), wrong.end(), error.what()) == wrong.end()) wrong.emplace_back(error.what());
  }
}

}  // namespace cosurge
