// Any bytes as a case file: read, or rejected with a message.
#include <fstream>

#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "tests/support/scratch_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const cosurge::testing::ScratchFolder folder;
  static const std::string file = folder.path() / "case.toml";
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<long>(size));
  try {
    cosurge::doubts(cosurge::load_case(file));
  } catch (const cosurge::Error&) {
  }
  return 0;
}
