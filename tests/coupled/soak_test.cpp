// Very many windows: neither the memory nor the number of open files of a run grows with them.
#include <gtest/gtest.h>

#include "coupler/checkpoint.hpp"
#include "coupler/launcher.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/own_memory.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

constexpr std::uint64_t windows_a_frame = 100;
// [bytes] Growth of the memory per window, until HDF5's cache of the results' index is full. A history that
// stays in memory takes 8 bytes per column, and there are 20.
constexpr double most_of_a_window = 25;
constexpr double flat = 0.01;  // allowed growth afterwards, relative to the memory
// [bytes] additional growth: the recorder keeps the time of each frame, in a vector with up to twice the
// capacity
constexpr double most_of_a_frame = 16;

/// Memory of a run after some windows.
struct Taken {
  double memory;  // [kB]
  std::size_t files;
};

/// Measures at a number of windows.
class Measurement : public Observer {
 public:
  explicit Measurement(std::uint64_t at) : at_(at) {}
  void window(const Window&, const Reports&, const std::vector<double>&) override {}
  void frame(double, const std::vector<Snapshot>&) override {
    if (++frames_ == at_ / windows_a_frame) taken = {testing::own_memory(), testing::open_files()};
  }
  Taken taken{};

 private:
  std::uint64_t at_;
  std::uint64_t frames_ = 0;
};

/// The piston under water, each in a thread of its own behind a wire, with results and checkpoints.
void expect_flat(std::uint64_t windows, const std::function<double(double)>& most_growth) {
  const testing::ScratchFolder folder;
  const testing::Piston piston;
  v1::Case the_case = testing::piston_case();
  the_case.mutable_time()->set_end(1e-3 * static_cast<double>(windows));
  the_case.mutable_output()->set_frame_interval(1e-3 * windows_a_frame);
  Solver fluid = Solver::thread(testing::water_column(piston), 60, 1);
  Solver solid = Solver::thread(testing::sprung_piston(piston), 60, 1);
  fluid.join(2, {});
  solid.join(2, {});
  Coupler coupler(the_case,
                  {dynamic_cast<Fluid*>(&fluid.participant()), dynamic_cast<Solid*>(&solid.participant())});
  Recorder recorder(folder.path(), the_case, coupler.members(), coupler.interface(), coupler.columns());
  CheckpointWriter checkpoints(folder.path(), the_case, coupler);
  Measurement early(windows / 5), late(windows - windows_a_frame);
  ASSERT_TRUE(coupler.run({&recorder, &checkpoints, &early, &late}, [] { return false; }));
  ASSERT_GE(coupler.windows(), windows);
  ASSERT_GT(early.taken.memory, 0);
  EXPECT_EQ(early.taken.files, late.taken.files);
  if (!testing::memory_can_be_measured) return;
  EXPECT_LT(late.taken.memory - early.taken.memory, most_growth(early.taken.memory))
      << early.taken.memory << " kB after a fifth, " << late.taken.memory << " kB at the end";
}

TEST(Soak, AHundredThousandWindowsKeepNothingButTheIndexOfTheirResults) {
  constexpr std::uint64_t windows = 100000;
  expect_flat(windows, [](double) { return most_of_a_window * 0.8 * windows / 1024; });
}

TEST(LongSoak, AMillionWindowsKeepNothingButTheTimesOfTheirFrames) {
  constexpr std::uint64_t windows = 1000000;
  constexpr double times = most_of_a_frame * windows / windows_a_frame / 1024;  // kB
  expect_flat(windows, [](double early) { return flat * early + times; });
}

}  // namespace
}  // namespace cosurge
