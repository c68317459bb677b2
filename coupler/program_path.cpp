#include "coupler/program_path.hpp"

#include <dlfcn.h>

#include "common/error.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

/// The folder of the file that contains this code: the shared library, otherwise the program.
fs::path folder_of_this_code() {
  Dl_info object{};
  if (dladdr(reinterpret_cast<const void*>(&program_path), &object) == 0) return {};
  // Symbolic links are resolved, because the loader may have used /lib, a link to /usr/lib.
  fs::path folder = fs::canonical(object.dli_fname).parent_path();
  // The loader prefers libraries for the processor's level: lib/glibc-hwcaps/x86-64-v3/.
  if (folder.parent_path().filename() == "glibc-hwcaps") folder = folder.parent_path().parent_path();
  return folder;
}

}  // namespace

fs::path program_path(const std::string& name) {
  const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path() / name;
  if (fs::exists(beside)) return beside;
  const fs::path installed =
      (folder_of_this_code() / COSURGE_PROGRAMS_FROM_LIBRARY / name).lexically_normal();
  require(fs::exists(installed),
          "{} is missing: it is neither in {} nor in {}; install Cosurge anew, or build the target {}", name,
          beside.parent_path().string(), installed.parent_path().string(), name);
  return installed;
}

}  // namespace cosurge
