#include "coupler/replace_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "common/error.hpp"

namespace cosurge {

void replace_file(const std::filesystem::path& path, std::initializer_list<std::string_view> parts) {
  const std::filesystem::path fresh = path.string() + ".new";
  errno = 0;
  std::ofstream out(fresh, std::ios::binary);
  for (const std::string_view part : parts) out << part;
  out.close();
  const int cause = errno;
  require(!out.fail(), "{}: cannot be written: {}", fresh.string(), std::generic_category().message(cause));
  std::error_code renamed;
  std::filesystem::rename(fresh, path, renamed);
  require(!renamed, "{}: cannot be replaced: {}", path.string(), renamed.message());
}

}  // namespace cosurge
