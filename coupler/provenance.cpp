#include "coupler/provenance.hpp"

#include <H5Cpp.h>

#include <sstream>

#include "common/error.hpp"
#include "coupler/result_file.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

std::string attribute(const H5::H5File& file, const std::string& name) {
  return file.attrExists(name) ? text_of(file.openAttribute(name)) : "";
}

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
  try {
    const H5::H5File file(results.string(), H5F_ACC_RDONLY);
    return {.case_file = attribute(file, "case_file"),
            .overrides = lines_of(attribute(file, "set")),
            .changes = lines_of(attribute(file, "changes"))};
  } catch (const H5::Exception& exception) {  // not a std::exception
    throw Error(fmt::format("{}: cannot be read: {}", results.string(), exception.getDetailMsg()));
  }
}

}  // namespace cosurge
