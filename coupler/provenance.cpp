#include "coupler/provenance.hpp"

#include <sstream>

#include "coupler/results.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

Provenance Provenance::of_case(const std::string& path, const std::vector<std::string>& overrides) {
  const fs::path file = fs::is_directory(path) ? fs::path(path) / "case.toml" : fs::path(path);
  return {.case_file = fs::absolute(file).lexically_normal().string(), .overrides = overrides, .changes = {}};
}

Provenance Provenance::of_results(const fs::path& results) {
  const Results file(results);
  return {.case_file = file.attribute("case_file"),
          .overrides = lines_of(file.attribute("set")),
          .changes = lines_of(file.attribute("changes"))};
}

}  // namespace cosurge
