// Any datasets instead of the rows and frames for a resumption: accepted, or rejected with a message. (The
// library rejects files that are not HDF5.)
#include <H5Cpp.h>
#include <fuzzer/FuzzedDataProvider.h>

#include "coupler/checkpoint.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

/// A dataset of any type, rank and extent; its space may be larger than any memory, where nothing is stored.
void put(const H5::H5File& file, const std::string& name, FuzzedDataProvider& choice) {
  if (choice.ConsumeIntegralInRange(0, 15) == 0) return;  // it is missing
  const H5::DataType types[] = {H5::PredType::NATIVE_DOUBLE, H5::PredType::NATIVE_FLOAT,
                                H5::PredType::NATIVE_INT64, H5::StrType(H5::PredType::C_S1, 8)};
  const int rank = choice.ConsumeBool() ? 1 : choice.ConsumeIntegralInRange(0, 4);
  std::vector<hsize_t> size, endless, chunk;
  for (int k = 0; k < rank; ++k) {
    size.push_back(choice.ConsumeIntegralInRange(0, 9) == 0
                       ? hsize_t{1} << choice.ConsumeIntegralInRange(0, 50)
                       : choice.ConsumeIntegralInRange<hsize_t>(0, 4));
    endless.push_back(H5S_UNLIMITED);
    chunk.push_back(4);
  }
  H5::LinkCreatPropList link;
  link.setCreateIntermediateGroup(true);
  H5::DSetCreatPropList layout;
  if (rank > 0) layout.setChunk(rank, chunk.data());
  const H5::DataSpace space = rank > 0 ? H5::DataSpace(rank, size.data(), endless.data()) : H5::DataSpace();
  const auto& type = choice.ConsumeIntegralInRange(0, 3) == 0 ? choice.PickValueInArray(types) : types[0];
  H5::DataSet dataset = file.createDataSet(name, type, space, layout, H5::DSetAccPropList::DEFAULT, link);
  if (choice.ConsumeIntegralInRange(0, 3) == 0)
    dataset.createAttribute("unit", choice.PickValueInArray(types), H5::DataSpace());
}

void replay_strange(const std::filesystem::path& folder, FuzzedDataProvider& choice) {
  const testing::Piston piston;
  const auto fluid = testing::water_column(piston);
  Coupler coupler(testing::piston_case(), {.fluid = fluid.get(), .solid = nullptr});
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  Recorder recorder(folder, testing::piston_case(), coupler.members(), coupler.interface(), coupler.columns(),
                    {}, "new");
  const std::filesystem::path results = folder / "old.h5";
  try {
    const H5::H5File file(results.string(), H5F_ACC_TRUNC);
    for (const History& history : recorder.histories()) put(file, "/history/" + history.name(), choice);
    for (const char* name : {"/frames/time", "/frames/fluid/state", "/frames/fluid/more"})
      put(file, name, choice);
  } catch (const H5::Exception&) {
    return;  // no such file can be made
  }
  const Checkpoint checkpoint{.build = "",
                              .solvers = {},
                              .the_case = testing::piston_case(),
                              .time = 0,
                              .windows = choice.ConsumeIntegralInRange<std::uint64_t>(0, 3),
                              .frames = choice.ConsumeIntegralInRange<std::uint64_t>(0, 3),
                              .state = ""};
  replay(results, checkpoint, recorder);
}

}  // namespace
}  // namespace cosurge

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const cosurge::testing::ScratchFolder folder;
  H5::Exception::dontPrint();
  FuzzedDataProvider choice(data, size);
  try {
    cosurge::replay_strange(folder.path() / "run", choice);
  } catch (const cosurge::Error&) {
  }
  return 0;
}
