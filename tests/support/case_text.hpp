// Case files for the tests: a valid one, and the errors if a line is spoiled.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {

inline constexpr const char* good_case = R"(title   = "Plate in water"
gravity = [0.0, -9.81]

[time]
end    = 0.1
window = 1.0e-3

[fluid]
spacing = 0.01
source  = "mixed"
tank    = { min = [0.0, 0.0], max = [0.3, 0.3] }
water   = [{ min = [0.0, 0.0], max = [0.1, 0.2] }, { min = [0.15, 0.0], max = [0.2, 0.2] }]
pressure = { max_iterations = 500 }

[solid]
model         = "mps"
density       = 2500.0
young_modulus = 1.0e6

[[solid.body]]
box   = { min = [0.1, 0.0], max = [0.14, 0.1] }
clamp = [{ min = [0.1, -0.02], max = [0.14, 0.0] }]

[coupling]
scheme = "weak"

[output]
frame_interval = 0.01
[[output.probe]]
name = "tip"
quantity = "displacement"
position = [0.1, 0.1]
[[output.probe]]
name = "P1"
quantity = "pressure"
position = [0.1, 0.05]
)";

/// The good case in a file of its own, with `from` replaced.
class CaseText {
 public:
  CaseText() : CaseText("", "") {}
  CaseText(const std::string& from, const std::string& to) : text_(good_case) {
    const auto at = text_.find(from);
    if (at == std::string::npos) throw std::logic_error("the good case has no \"" + from + "\"");
    text_.replace(at, from.size(), to);
    std::ofstream(file()) << text_;
  }

  std::string file() const { return (folder_.path() / "case.toml").string(); }
  const std::string& text() const { return text_; }

 private:
  ScratchFolder folder_;
  std::string text_;
};

/// Number of the line that holds `words`.
inline long line_of(const CaseText& c, const std::string& words) {
  const auto at = c.text().find(words);
  if (at == std::string::npos) throw std::logic_error("no line with " + words);
  return 1 + std::count(c.text().begin(), c.text().begin() + static_cast<long>(at), '\n');
}

/// The message of load_case(); empty if it accepts the case. Errors of other types are not caught.
inline std::string errors_of(const std::string& path, const std::vector<std::string>& overrides = {}) {
  try {
    load_case(path, overrides);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace cosurge::testing
