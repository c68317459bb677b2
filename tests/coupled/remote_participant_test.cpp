#include "common/wire/remote_participant.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "coupler/launcher.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::MockFluid;
using ::testing::ThrowsMessage;

const testing::Piston piston;

/// A served water column, and the coupler's side of it.
struct Remote {
  explicit Remote(std::unique_ptr<MockFluid> mock = testing::water_column(piston))
      : solver(Solver::thread(std::move(mock), 10, 1)),
        participant(dynamic_cast<RemoteFluid&>(solver.join(2, {"save"}))) {}

  cosurge::Setup initialize() {
    cosurge::Setup setup = participant.initialize(testing::piston_case(), interface, load);
    motion = InterfaceMotion::at_rest(2, interface.points());
    return setup;
  }
  Report advance() { return participant.advance(window, motion, load); }

  Solver solver;
  RemoteFluid& participant;
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  Window window{.index = 212, .start = 0.0212, .size = 1e-4};
};

std::unique_ptr<MockFluid> with_advance(decltype(MockFluid::on_advance) advance) {
  auto mock = testing::water_column(piston);
  mock->on_advance = std::move(advance);
  return mock;
}

/// Windows of the weak scheme: the fluid with the solid's last motion, then the solid with the new load.
std::vector<double> weak_run(Fluid& fluid, Solid& solid, int windows) {
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  fluid.initialize(testing::piston_case(), interface, load);
  motion = InterfaceMotion::at_rest(2, interface.points());
  solid.initialize(testing::piston_case(), interface, load, motion);
  std::vector<double> heights;
  for (int n = 0; n < windows; ++n) {
    const Window window{.index = static_cast<std::uint64_t>(n), .start = n * 1e-3, .size = 1e-3};
    fluid.advance(window, motion, load);
    heights.push_back(solid.advance(window, load, motion).values.at(0));
  }
  fluid.finalize();
  solid.finalize();
  return heights;
}

TEST(RemoteParticipant, ComputesTheSameBitsAsADirectOne) {
  const auto fluid = testing::water_column(piston);
  const auto solid = testing::sprung_piston(piston);
  const std::vector<double> direct = weak_run(*fluid, *solid, 200);
  Solver far_fluid = Solver::thread(testing::water_column(piston), 10, 1);
  Solver far_solid = Solver::thread(testing::sprung_piston(piston), 10, 1);
  EXPECT_EQ(weak_run(dynamic_cast<RemoteFluid&>(far_fluid.join(2, {})),
                     dynamic_cast<RemoteSolid&>(far_solid.join(2, {})), 200),
            direct);
  EXPECT_NE(direct.back(), 0);
}

TEST(RemoteParticipant, SaysWhoItIsAndWhatItReports) {
  Remote remote;
  EXPECT_EQ(remote.participant.identity().program, "mock_fluid");
  const cosurge::Setup setup = remote.initialize();
  EXPECT_EQ(setup.columns.at(0).unit, "Pa");
  EXPECT_EQ(remote.interface.points(), piston.points);
  const Report report = remote.advance();
  // At rest the pressure carries the weight of the column.
  EXPECT_DOUBLE_EQ(report.values.at(0), piston.density * piston.gravity * piston.height);
  EXPECT_EQ(remote.participant.frame().at(0).name, "state");
}

TEST(RemoteParticipant, ContinuesFromASavedState) {
  Remote remote;
  remote.initialize();
  remote.motion.velocity.setConstant(0.1);
  remote.advance();
  const std::string state = remote.participant.save();
  const Report once = remote.advance();
  remote.participant.restore(state);
  EXPECT_EQ(remote.advance().values, once.values);
}

TEST(RemoteParticipant, StatesAndFramesMayBeLargerThanAMessage) {
  // 80 MB of a frame, 160 MB of a state.
  auto mock = testing::water_column(piston);
  MockFluid& fluid = *mock;
  Remote remote(std::move(mock));
  remote.initialize();
  fluid.state.resize(20'000'000);
  for (std::size_t k = 0; k < fluid.state.size(); ++k) fluid.state[k] = 0.5 * static_cast<double>(k);
  const std::vector<double> sent = fluid.state;
  const std::string state = remote.participant.save();
  EXPECT_TRUE(state == fluid.save());
  const Snapshot frame = remote.participant.frame();
  ASSERT_EQ(frame.size(), 1U);
  EXPECT_TRUE(frame[0].values == std::vector<float>(sent.begin(), sent.end()));
  fluid.state.assign(sent.size(), 0);
  remote.participant.restore(state);
  EXPECT_TRUE(fluid.state == sent);
  EXPECT_LT(remote.participant.cost().bytes / remote.participant.cost().messages, std::size_t{1} << 26);
}

TEST(RemoteParticipant, NamesSolverFieldPointAndWindowOfANumberThatIsNotFinite) {
  Remote remote(with_advance([](const Window&, const InterfaceMotion&, InterfaceLoad& load) {
    load.force(0, 2) = std::numeric_limits<double>::quiet_NaN();
    return Report{.values = {0}, .window = 1};
  }));
  remote.initialize();
  EXPECT_THAT(
      [&] { remote.advance(); },
      ThrowsMessage<Error>("mock_fluid 0.1.0: force of point 2 is nan [advance, window 212 (t = 0.0212 s)]"));
  EXPECT_THAT([&] { remote.participant.save(); },
              ThrowsMessage<Error>("mock_fluid 0.1.0: save was requested after its end"));
}

TEST(RemoteParticipant, ThrowsWhatTheSolverThrowsAndOfTheSameKind) {
  Remote numerical(with_advance([](const Window&, const InterfaceMotion&, InterfaceLoad&) -> Report {
    throw NumericalError("diverged");
  }));
  numerical.initialize();
  EXPECT_THAT(
      [&] { numerical.advance(); },
      ThrowsMessage<NumericalError>("mock_fluid 0.1.0: diverged [advance, window 212 (t = 0.0212 s)]"));
  Remote other(with_advance(
      [](const Window&, const InterfaceMotion&, InterfaceLoad&) -> Report { throw std::bad_alloc(); }));
  other.initialize();
  EXPECT_THAT([&] { other.advance(); }, ThrowsMessage<Error>(HasSubstr("mock_fluid 0.1.0: std::bad_alloc")));
}

TEST(RemoteParticipant, RefusesASolverOfAnotherDimensionOrWithoutACapability) {
  auto flat = testing::water_column(piston);
  flat->who.dimensions = {2};
  Solver solver = Solver::thread(std::move(flat), 10, 1);
  EXPECT_THAT([&] { solver.join(3, {}); },
              ThrowsMessage<Error>("mock_fluid 0.1.0: refused: it does not support 3 dimensions"));
  Solver plain = Solver::thread(testing::water_column(piston), 10, 1);
  EXPECT_THAT([&] { plain.join(2, {"fly"}); },
              ThrowsMessage<Error>("mock_fluid 0.1.0: refused: it does not support \"fly\""));
}

TEST(RemoteParticipant, TellsComputingFromTheExchange) {
  static constexpr double computing = 0.05;  // [s]
  Remote remote(with_advance([](const Window&, const InterfaceMotion&, InterfaceLoad&) {
    std::this_thread::sleep_for(std::chrono::duration<double>(computing));
    return Report{.values = {0}, .window = 1};
  }));
  remote.initialize();
  remote.advance();
  const RemoteParticipant::Cost cost = remote.participant.cost();
  EXPECT_EQ(cost.calls, 3U);     // welcome, initialize, advance
  EXPECT_EQ(cost.messages, 7U);  // hello, and two a call
  EXPECT_GE(cost.computing, computing);
  EXPECT_LT(cost.exchange(), computing);  // microseconds by rights; room for a busy machine
  EXPECT_GT(cost.exchange(), 0);
  EXPECT_GT(cost.bytes, 5U * 2 * 3 * 8);  // displacement, velocity and force alone
}

TEST(RemoteParticipant, EndsTheSolverWithItself) {
  bool finalized = false;
  {
    auto mock = testing::water_column(piston);
    mock->on_finalize = [&finalized] { finalized = true; };
    Remote remote(std::move(mock));
    remote.initialize();
  }  // hangs here where the solver is not told
  EXPECT_FALSE(finalized);
}

TEST(Solver, ThatIsNeverJoinedEndsToo) {
  const auto start = std::chrono::steady_clock::now();
  { const Solver solver = Solver::thread(testing::water_column(piston), 10, 1); }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));  // a tenth, and room
}

}  // namespace
}  // namespace cosurge
