// Any bytes as a checkpoint, with a right checksum or without: restored, or rejected with a message.
#include <zlib.h>

#include <array>
#include <fstream>
#include <optional>
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

constexpr std::array schemes = {v1::Coupling::weak, v1::Coupling::strong, v1::Coupling::weak_inertial,
                                v1::Coupling::strong_inertial, v1::Coupling::auto_};

/// A run of mocks with one of the schemes.
struct Run {
  explicit Run(std::size_t scheme) : the_case(testing::piston_case()) {
    the_case.mutable_coupling()->set_scheme(schemes[scheme]);
    coupler.emplace(the_case, Participants{.fluid = fluid.get(), .solid = solid.get()});
  }

  /// Some windows, or fewer up to the end.
  void go_on(int windows) {
    coupler->run({}, [&] { return --windows < 0; });
  }

  v1::Case the_case;
  testing::Piston piston{.tells_mode = true};
  std::unique_ptr<testing::MockFluid> fluid = testing::water_column(piston);
  std::unique_ptr<testing::MockSolid> solid = testing::sprung_piston(piston);
  std::optional<Coupler> coupler;
};

/// The checkpoint of a run whose scheme has data in all its fields.
std::string legal_checkpoint(const std::filesystem::path& folder, std::size_t scheme) {
  constexpr int windows = 25;
  Run run(scheme);
  run.go_on(windows);
  CheckpointWriter(folder, run.the_case, *run.coupler).write();
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

/// Parts: for each scheme the content, and the whole file.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  static const std::vector<std::string> legal = [] {
    std::vector<std::string> parts;
    for (std::size_t scheme = 0; scheme < cosurge::schemes.size(); ++scheme) {
      const std::string file = cosurge::legal_checkpoint(cosurge::folder(), scheme);
      parts.push_back(file.substr(cosurge::mark.size() + cosurge::seal));
      parts.push_back(file);
    }
    return parts;
  }();
  return cosurge::testing::legal_or_mutated(legal, data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cosurge;
  static const bool quiet = std::fclose(stdout) == 0;  // suppress warnings
  if (size == 0 || !quiet) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  std::filesystem::remove(folder() / Checkpoint::name_before);
  std::ofstream(folder() / Checkpoint::name, std::ios::binary) << (data[0] % 2 == 0 ? sealed(bytes) : bytes);
  try {
    const Checkpoint checkpoint = Checkpoint::read(folder());
    Run run(data[0] / 2 % schemes.size());
    checkpoint.require_same_programs(run.coupler->members());
    run.coupler->restore(checkpoint.state);
    run.go_on(3);
  } catch (const Error&) {
  }
  return 0;
}
