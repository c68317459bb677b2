// Another program reads the results at every frame of a run, and finds no wrong number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupler/checkpoint.hpp"
#include "coupler/coupler.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

constexpr std::uint64_t windows_a_frame = 3;
constexpr std::size_t particles = 1000;

/// Value of the particles of both solvers at the end of a window; particle p has k + p / 1024 at frame k.
void move(std::vector<double>& state, const Window& window) {
  const double frame = static_cast<double>(window.index + 1) / windows_a_frame;
  for (std::size_t p = 0; p < state.size(); ++p) state[p] = frame + static_cast<double>(p) / 1024;
}

/// Row i of column c is i + c / 8.
std::vector<double> row(const Window& window, int first, int columns) {
  std::vector<double> values;
  for (int k = first; k < first + columns; ++k) values.push_back(static_cast<double>(window.index) + k / 8.0);
  return values;
}

/// Waits at every frame until the reader has finished a reading since the last frame but one. So it reads
/// while the next frame is written.
class WithReader : public Observer {
 public:
  explicit WithReader(testing::Program& reader, const std::filesystem::path& output)
      : reader_(reader), output_(output) {}
  void window(const Window&, const Reports&, const std::vector<double>&) override {}
  void frame(double, const std::vector<Snapshot>&) override {
    ++frames_;
    while (reader_.running() && std::filesystem::file_size(output_) + 1 < frames_)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
  }

 private:
  testing::Program& reader_;
  std::filesystem::path output_;
  std::uint64_t frames_ = 0;
};

void read_at_every_frame(std::uint64_t frames) {
  const testing::ScratchFolder folder;
  const auto output = folder.path() / "reader.log", done = folder.path() / "done";
  testing::Program reader({"/usr/bin/python3", COSURGE_SOURCE_DIR "/tests/coupled/read_during_run.py",
                           folder.path() / "results.h5", std::to_string(windows_a_frame), done},
                          output);
  v1::Case the_case = testing::piston_case();
  the_case.mutable_time()->set_stepping(v1::Time::fixed);
  the_case.mutable_time()->set_end(1e-3 * static_cast<double>(windows_a_frame * frames));
  the_case.mutable_output()->set_frame_interval(1e-3 * windows_a_frame);
  the_case.mutable_coupling()->set_scheme(v1::Coupling::weak);
  const auto fluid = testing::water_column({});
  const auto solid = testing::sprung_piston({});
  for (auto* state : {&fluid->state, &solid->state}) {
    state->resize(particles);
    move(*state, {.index = ~std::uint64_t{0}, .start = 0, .size = 0});
  }
  fluid->on_initialize = [](const v1::Case&, Interface& interface, InterfaceLoad& load) {
    interface = {.dimension = 2, .position = Field(2, 0), .area = Field(2, 0), .body = {}};
    load = InterfaceLoad::zero(2, 0);
    return Setup{.columns = {{"first", "-"}, {"second", "-"}}, .particles = particles, .window = 1};
  };
  fluid->on_advance = [&](const Window& window, const InterfaceMotion&, InterfaceLoad&) {
    move(fluid->state, window);
    return Report{.values = row(window, 0, 2), .window = 1};
  };
  solid->on_initialize = [](const v1::Case&, const Interface&, const InterfaceLoad&, InterfaceMotion&) {
    return Setup{.columns = {{"first", "-"}}, .particles = particles, .window = 1};
  };
  solid->on_advance = [&](const Window& window, const InterfaceLoad&, InterfaceMotion&) {
    move(solid->state, window);
    return Report{.values = row(window, 2, 1), .window = 1};
  };
  Coupler coupler(the_case, {.fluid = fluid.get(), .solid = solid.get()});
  Recorder recorder(folder.path(), the_case, coupler.members(), coupler.interface(), coupler.columns());
  CheckpointWriter checkpoints(folder.path(), the_case, coupler);
  WithReader with_reader(reader, output);
  ASSERT_TRUE(coupler.run({&recorder, &checkpoints, &with_reader}, [&] { return !reader.running(); }))
      << reader.output();
  std::ofstream(done) << "done";
  ASSERT_EQ(reader.wait(300), 0) << reader.output();
  const std::string said = reader.output();
  EXPECT_THAT(said, ::testing::HasSubstr(fmt::format(", {} frames", frames + 1)));
  const auto reads = static_cast<std::uint64_t>(std::count(said.begin(), said.end(), '.'));
  EXPECT_GE(reads, frames - frames / 20)
      << "errors of the library instead of reads: " << std::count(said.begin(), said.end(), 'e');
}

TEST(Reader, FindsNoWrongNumberAtAnyOfAThousandFrames) { read_at_every_frame(1000); }

TEST(LongReader, FindsNoWrongNumberAtAnyOfTenThousandFrames) { read_at_every_frame(10000); }

}  // namespace
}  // namespace cosurge
