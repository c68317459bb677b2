// Any bytes as a checkpoint, with a right checksum or without: restored, or rejected with a message.
#include <zlib.h>

#include <fstream>
#include <sstream>

#include "common/state_bytes.hpp"
#include "coupler/checkpoint.hpp"
#include "tests/fuzz/legal_seed.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

constexpr std::size_t seal = sizeof(std::uint64_t) + sizeof(std::uint32_t);
const std::string mark = "cosurge checkpoint, sealed\n";

/// A run of mocks, and its checkpoint's bytes.
struct Run {
  testing::Piston piston;
  std::unique_ptr<testing::MockFluid> fluid = testing::water_column(piston);
  std::unique_ptr<testing::MockSolid> solid = testing::sprung_piston(piston);
  Coupler coupler{testing::piston_case(), {.fluid = fluid.get(), .solid = solid.get()}};
};

std::string legal_checkpoint(const std::filesystem::path& folder) {
  Run run;
  CheckpointWriter(folder, testing::piston_case(), run.coupler).write();
  std::ostringstream bytes;
  bytes << std::ifstream(folder / Checkpoint::name, std::ios::binary).rdbuf();
  return bytes.str();
}

/// The file of a content, with its length and checksum.
std::string sealed(const std::string& content) {
  StateWriter head;
  head.put(static_cast<std::uint64_t>(content.size()));
  head.put(static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(content.data()), content.size())));
  return mark + head.take() + content;
}

const std::filesystem::path& folder() {
  static const testing::ScratchFolder scratch;
  return scratch.path();
}

}  // namespace
}  // namespace cosurge

/// Part 0 is the content, part 1 the whole file.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  static const std::string file = cosurge::legal_checkpoint(cosurge::folder());
  static const std::vector<std::string> legal = {file.substr(cosurge::mark.size() + cosurge::seal), file};
  return cosurge::testing::legal_or_mutated(legal, data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cosurge;
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  std::filesystem::remove(folder() / Checkpoint::name_before);
  std::ofstream(folder() / Checkpoint::name, std::ios::binary) << (data[0] % 2 == 0 ? sealed(bytes) : bytes);
  std::fclose(stdout);  // suppress warnings
  try {
    const Checkpoint checkpoint = Checkpoint::read(folder());
    Run run;
    checkpoint.require_same_programs(run.coupler.members());
    run.coupler.restore(checkpoint.state);
  } catch (const Error&) {
  }
  return 0;
}
