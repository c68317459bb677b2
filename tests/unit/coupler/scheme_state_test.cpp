// Saved states of coupling schemes that do not fit the run that restores them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "coupler/coupler.hpp"
#include "coupler/schemes/strong/iqn_ils.hpp"
#include "tests/support/mock_participant.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int dimension = 2, points = 6;

template <typename State>
std::string saved(const State& state) {
  StateWriter writer;
  state.save(writer);
  return writer.take();
}

/// A history of two windows, three iterations in each, of an interface with so many numbers.
std::string history_of(int numbers) {
  IqnIls relaxation(0.5, 5);
  for (int window = 0; window < 2; ++window) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(numbers);
    for (int k = 0; k < 3; ++k) x = relaxation.next(x, Eigen::VectorXd::Random(numbers));
    relaxation.end_window();
  }
  return saved(relaxation);
}

/// Restores a history of the interface quasi-Newton scheme into a run of 2 x 6 numbers.
auto restored(const std::string& state, int reuse = 5) {
  return [state, reuse] {
    IqnIls relaxation(0.5, reuse);
    InterfaceReader reader(state, dimension, points);
    relaxation.restore(reader);
    const Eigen::VectorXd x = Eigen::VectorXd::Zero(dimension * points);
    relaxation.next(x, Eigen::VectorXd::Ones(dimension * points));
  };
}

std::string counts(const std::vector<int>& of_windows) {
  StateWriter writer;
  writer.put(of_windows);
  return writer.take();
}

TEST(IqnIlsState, ComesBack) {
  const std::string state = history_of(dimension * points);
  IqnIls relaxation(0.5, 5);
  InterfaceReader reader(state, dimension, points);
  relaxation.restore(reader);
  reader.finish();
  EXPECT_EQ(saved(relaxation), state);
}

TEST(IqnIlsState, OfAnotherInterfaceIsRefused) {
  for (const int numbers : {1, 4, 11, 13, 24})
    EXPECT_THAT(restored(history_of(numbers)),
                ThrowsMessage<Error>(HasSubstr(
                    fmt::format("a field of the interface has {} x 1 numbers instead of 12 x 1", numbers))));
}

TEST(IqnIlsState, WithImpossibleNumbersOfColumnsIsRefused) {
  EXPECT_THAT(restored(counts({})), ThrowsMessage<Error>(HasSubstr("columns of 0 windows")));
  EXPECT_THAT(restored(counts({0, 0, 0, 0})), ::testing::Not(::testing::Throws<Error>()));
  EXPECT_THAT(restored(counts({0, 0, 0, 0}), 2), ThrowsMessage<Error>(HasSubstr("must have them of 1 to 3")));
  EXPECT_THAT(restored(counts({1, -1})), ThrowsMessage<Error>(HasSubstr("none fewer than 0")));
  EXPECT_THAT(restored(counts({1 << 30})), ThrowsMessage<Error>(HasSubstr("too short")));
}

TEST(AddedMassRatioState, WithoutTheFieldsThatItHasSeenIsRefused) {
  AddedMassRatio ratio;
  const Field velocity = Field::Ones(dimension, points);
  for (int k = 0; k < 2; ++k) ratio.passed(k * velocity, {.index = 0, .start = 0, .size = 1});
  const std::string state = saved(ratio);
  for (const int seen : {-1, 0, 1, 2, 3, 4}) {
    std::string changed = state;
    std::memcpy(changed.data() + sizeof(double), &seen, sizeof seen);
    InterfaceReader reader(changed, dimension, points);
    AddedMassRatio other;
    if (seen == 2)
      EXPECT_NO_THROW(other.restore(reader));
    else
      EXPECT_THAT([&] { other.restore(reader); },
                  ThrowsMessage<Error>(HasSubstr(fmt::format("has seen {} windows", seen))));
  }
}

/// A run of mocks; `scheme` couples them.
struct MockRun {
  explicit MockRun(v1::Coupling::Scheme scheme) {
    v1::Case the_case = testing::piston_case();
    the_case.mutable_time()->set_end(0.05);
    the_case.mutable_coupling()->set_scheme(scheme);
    the_case.mutable_coupling()->mutable_iteration()->set_relaxation(v1::Iteration::iqn_ils);
    coupler.emplace(the_case, Participants{.fluid = fluid.get(), .solid = solid.get()});
  }

  testing::Piston piston{.points = points};
  std::unique_ptr<testing::MockFluid> fluid = testing::water_column(piston);
  std::unique_ptr<testing::MockSolid> solid = testing::sprung_piston(piston);
  std::optional<Coupler> coupler;
};

class SchemeState : public ::testing::TestWithParam<v1::Coupling::Scheme> {};

// Whatever single number of a state is damaged: the run refuses it, or goes on to its end or to an error.
TEST_P(SchemeState, WithADamagedNumberIsRefusedOrComputesOn) {
  MockRun whole(GetParam());
  int windows = 0;
  whole.coupler->run({}, [&] { return ++windows > 25; });
  const std::string state = whole.coupler->save();
  int refused = 0;
  for (std::size_t at = 0; at < state.size(); ++at) {
    std::string damaged = state;
    damaged[at] = static_cast<char>(~damaged[at]);
    MockRun run(GetParam());
    int left = 10;
    try {
      run.coupler->restore(damaged);
      run.coupler->run({}, [&] { return --left < 0; });
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SchemeState,
                         ::testing::Values(v1::Coupling::weak, v1::Coupling::strong,
                                           v1::Coupling::weak_inertial, v1::Coupling::strong_inertial,
                                           v1::Coupling::auto_),
                         [](const auto& test) { return v1::Coupling::Scheme_Name(test.param); });

}  // namespace
}  // namespace cosurge
