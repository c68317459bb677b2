#include "common/wire/convert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "common/wire/parts.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

InterfaceMotion random_motion(Eigen::Index points) {
  InterfaceMotion motion = InterfaceMotion::at_rest(2, points);
  std::srand(1);
  motion.displacement.setRandom();
  motion.velocity.setRandom();
  motion.ramp_increment.setRandom();
  return motion;
}

InterfaceLoad random_load(Eigen::Index points) {
  InterfaceLoad load = InterfaceLoad::zero(2, points);
  std::srand(2);
  load.force.setRandom();
  load.pressure.setRandom();
  return load;
}

TEST(InterfaceMotion, ComesBackBitForBit) {
  InterfaceMotion sent = random_motion(30);
  sent.displacement(1, 4) = -0.0;
  v1::Motion message;
  encode(sent, message);
  InterfaceMotion received = InterfaceMotion::at_rest(2, 30);
  decode(message, received);
  EXPECT_EQ(received.displacement, sent.displacement);
  EXPECT_TRUE(std::signbit(received.displacement(1, 4)));
  EXPECT_EQ(received.velocity, sent.velocity);
  EXPECT_EQ(received.ramp_increment, sent.ramp_increment);
}

TEST(InterfaceLoad, ComesBackBitForBit) {
  InterfaceLoad sent = random_load(30);
  sent.force(0, 3) = std::numeric_limits<double>::denorm_min();
  v1::Load message;
  encode(sent, message);
  InterfaceLoad received = InterfaceLoad::zero(2, 30);
  decode(message, received);
  EXPECT_EQ(received.force, sent.force);
  EXPECT_EQ(received.pressure, sent.pressure);
}

TEST(InterfaceMotion, CarriesModesBitForBitAndRefusesThoseThatAreNoNumbers) {
  InterfaceMotion sent = random_motion(4);
  sent.modes = {{.shape = Field::Random(2, 4), .mobility = 0.25, .load = -3},
                {.shape = Field::Random(2, 4), .mobility = 0, .load = 0}};
  v1::Motion motion;
  encode(sent, motion);
  InterfaceMotion received = random_motion(4);
  decode(motion, received);
  ASSERT_EQ(received.modes.size(), 2U);
  EXPECT_EQ(received.modes[0].shape, sent.modes[0].shape);
  EXPECT_EQ(received.modes[0].mobility, 0.25);
  EXPECT_EQ(received.modes[0].load, -3);
  motion.mutable_modes(1)->set_mobility(nan);
  EXPECT_THAT([&] { decode(motion, received); },
              ThrowsMessage<Error>(HasSubstr("a mode has a mobility of nan")));
  sent.modes.clear();
  encode(sent, motion);
  decode(motion, received);
  EXPECT_TRUE(received.modes.empty());
}

TEST(InterfaceMotion, CarriesTheFrequencyAndRejectsNaNAndNegativeOnes) {
  InterfaceMotion sent = random_motion(4);
  sent.frequency = 12.5;
  v1::Motion motion;
  encode(sent, motion);
  InterfaceMotion received = random_motion(4);
  decode(motion, received);
  EXPECT_EQ(received.frequency, 12.5);
  for (const double wrong : {nan, -1.0}) {
    motion.set_frequency(wrong);
    EXPECT_THAT([&] { decode(motion, received); },
                ThrowsMessage<Error>(HasSubstr("must be finite and >= 0")));
  }
}

TEST(InterfaceMotion, SparesTheRampIncrementWhereItIsZeroAndResetsItOnArrival) {
  InterfaceMotion sent = random_motion(3);
  sent.ramp_increment.setZero();
  v1::Motion motion;
  encode(sent, motion);
  EXPECT_EQ(motion.ramp_increment_size(), 0);
  InterfaceMotion received = random_motion(3);
  decode(motion, received);
  EXPECT_TRUE(received.ramp_increment.isZero(0));

  sent.ramp_increment(0, 0) = -0.0;
  encode(sent, motion);
  EXPECT_EQ(motion.ramp_increment_size(), 6);
}

TEST(InterfaceLoad, NamesTheFieldAndThePointOfANumberThatIsNotFinite) {
  InterfaceLoad sent = random_load(30);
  sent.force(1, 17) = nan;
  v1::Load message;
  encode(sent, message);
  InterfaceLoad received = InterfaceLoad::zero(2, 30);
  EXPECT_THAT([&] { decode(message, received); }, ThrowsMessage<Error>("force of point 17 is nan"));

  sent = random_load(30);
  sent.pressure[29] = infinity;
  encode(sent, message);
  EXPECT_THAT([&] { decode(message, received); }, ThrowsMessage<Error>("pressure of point 29 is inf"));
}

TEST(InterfaceMotion, OfAnotherLengthIsRefused) {
  v1::Motion motion;
  encode(random_motion(4), motion);
  InterfaceMotion received = InterfaceMotion::at_rest(2, 5);
  EXPECT_THAT([&] { decode(motion, received); },
              ThrowsMessage<Error>("displacement has 8 numbers instead of 2 x 5"));
}

TEST(Interface, ComesBackAndIsCheckedAgainstTheCase) {
  const Interface sent{
      .dimension = 3, .position = Field::Random(3, 4), .area = Field::Random(3, 4), .body = {0, 0, 1, 1}};
  v1::Interface message;
  encode(sent, message);
  const Interface received = decode(message, 3, 2);
  EXPECT_EQ(received.position, sent.position);
  EXPECT_EQ(received.area, sent.area);
  EXPECT_EQ(received.body, sent.body);
  EXPECT_THAT([&] { decode(message, 2, 2); },
              ThrowsMessage<Error>("the interface has 3 dimensions, the case 2"));
  EXPECT_THAT([&] { decode(message, 3, 1); },
              ThrowsMessage<Error>("a point of the interface lies on body 1 of 1"));
  message.mutable_area()->RemoveLast();
  EXPECT_THAT([&] { decode(message, 3, 2); }, ThrowsMessage<Error>("area has 11 numbers instead of 3 x 4"));
}

TEST(Window, MustBeFiniteAndHaveALength) {
  for (const double wrong : {0.0, -1e-3, nan, infinity}) {
    v1::Window message;
    encode(Window{.index = 212, .start = 0.1, .size = wrong}, message);
    EXPECT_THAT([&] { decode(message); }, ThrowsMessage<Error>(HasSubstr("window 212 is"))) << wrong;
  }
}

TEST(Setup, MayLeaveTheWindowOpenButNotUndefined) {
  v1::Initialized message;
  encode(cosurge::Setup{.columns = {{"force", "N"}}, .particles = 7, .window = infinity, .substep = 1e-5},
         message);
  const cosurge::Setup setup = decode(message);
  EXPECT_EQ(setup.columns.at(0).name, "force");
  EXPECT_EQ(setup.columns.at(0).unit, "N");
  EXPECT_EQ(setup.particles, 7U);
  EXPECT_EQ(setup.window, infinity);
  EXPECT_EQ(setup.substep, 1e-5);
  message.set_window(nan);
  EXPECT_THAT([&] { decode(message); }, ThrowsMessage<Error>(HasSubstr("the largest window is nan s")));
}

TEST(Report, CarriesNotes) {
  v1::Advanced message;
  encode(Report{.values = {1}, .window = 1, .notes = {"one", "two"}}, message);
  EXPECT_EQ(decode(message, 1).notes, (std::vector<std::string>{"one", "two"}));
}

TEST(Report, HasOneFiniteValueAColumn) {
  v1::Advanced message;
  encode(Report{.values = {1, nan}, .window = 1}, message);
  EXPECT_THAT([&] { decode(message, 3); }, ThrowsMessage<Error>("2 values reported instead of 3"));
  EXPECT_THAT([&] { decode(message, 2); }, ThrowsMessage<Error>("reported value 1 is nan"));
  message.set_values(1, 2);
  EXPECT_EQ(decode(message, 2).values, (std::vector<double>{1, 2}));
}

TEST(Snapshot, ComesBackAndMustHaveWholeParticlesOfFiniteNumbers) {
  v1::Snapshot message;
  FrameParts({{.name = "velocity", .unit = "m/s", .components = 2, .values = {1, 2, 3, 4}}}).next(message);
  const Snapshot received = decode(message);
  EXPECT_EQ(received.at(0).name, "velocity");
  EXPECT_EQ(received.at(0).components, 2);
  EXPECT_EQ(received.at(0).values, (std::vector<float>{1, 2, 3, 4}));
  message.mutable_arrays(0)->set_values(3, std::numeric_limits<float>::infinity());
  EXPECT_THAT([&] { decode(message); }, ThrowsMessage<Error>("velocity of particle 1 is not finite"));
  message.mutable_arrays(0)->set_components(3);
  EXPECT_THAT([&] { decode(message); },
              ThrowsMessage<Error>("array velocity of a frame has 4 numbers of 3 components"));
}

TEST(Identity, ComesBackAndHasARole) {
  const Identity sent{"solid_solver", "0.1.0", {2, 3}, {"save"}};
  v1::Hello message;
  encode(Role::solid, sent, message);
  const Identity received = decode(message);
  EXPECT_EQ(role_of(message), Role::solid);
  EXPECT_EQ(received.program, sent.program);
  EXPECT_EQ(received.version, sent.version);
  EXPECT_EQ(received.dimensions, sent.dimensions);
  EXPECT_EQ(received.capabilities, sent.capabilities);
  message.set_role(v1::ROLE_UNSPECIFIED);
  EXPECT_THAT([&] { role_of(message); }, ThrowsMessage<Error>("role 0 is neither fluid nor solid"));
}

}  // namespace
}  // namespace cosurge
