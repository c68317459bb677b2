#include "coupler/result_folder.hpp"

#include "common/error.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// Makes a folder and those around it. False where it is there already: of many who try, one makes it.
bool make(const fs::path& folder) {
  std::error_code failed;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), failed);
  const bool made = !failed && fs::create_directory(folder, failed);
  require(!failed, "{}: cannot be made: {}", folder.string(), failed.message());
  return made;
}

bool holds_a_run(const fs::path& folder) {
  for (const char* name :
       {"results.h5", "results.h5.new", "summary.json", "checkpoint", "fluid_solver.log", "solid_solver.log"})
    if (fs::exists(folder / name)) return true;
  return false;
}

}  // namespace

std::string case_name(const fs::path& case_path) {
  fs::path path = fs::absolute(case_path).lexically_normal();
  if (path.filename().empty()) path = path.parent_path();  // "cases/mine/"
  return fs::is_directory(path) ? path.filename().string() : path.parent_path().filename().string();
}

fs::path take_folder(const fs::path& case_path, const fs::path& out) {
  if (!out.empty()) {
    fs::path folder = out.lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();  // "results/mine/"
    if (!fs::exists(folder) && make(folder)) return folder;
    require(fs::is_directory(folder), "{}: is no folder; choose another --out", folder.string());
    require(!holds_a_run(folder), "{}: holds results already; choose another --out", folder.string());
    return folder;
  }
  const std::string name = case_name(case_path);
  fs::path folder = fs::path("results") / name;
  for (int number = 2; !make(folder); ++number)
    folder = fs::path("results") / fmt::format("{}-{}", name, number);
  return folder;
}

}  // namespace cosurge
