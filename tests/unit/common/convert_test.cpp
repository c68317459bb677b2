#include "common/wire/convert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/error.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Surface random_surface(Eigen::Index points) {
  Surface surface = Surface::at_rest(2, points);
  std::srand(1);
  surface.displacement.setRandom();
  surface.velocity.setRandom();
  surface.ramp_increment.setRandom();
  surface.force.setRandom();
  surface.pressure.setRandom();
  return surface;
}

TEST(Surface, ComesBackBitForBit) {
  Surface sent = random_surface(30);
  sent.displacement(1, 4) = -0.0;
  sent.force(0, 3) = std::numeric_limits<double>::denorm_min();
  v1::Motion motion;
  v1::Load load;
  encode_motion(sent, motion);
  encode_load(sent, load);
  Surface received = Surface::at_rest(2, 30);
  decode_motion(motion, received);
  decode_load(load, received);
  EXPECT_EQ(received.displacement, sent.displacement);
  EXPECT_TRUE(std::signbit(received.displacement(1, 4)));
  EXPECT_EQ(received.velocity, sent.velocity);
  EXPECT_EQ(received.ramp_increment, sent.ramp_increment);
  EXPECT_EQ(received.force, sent.force);
  EXPECT_EQ(received.pressure, sent.pressure);
}

TEST(Surface, CarriesModesBitForBitAndRefusesThoseThatAreNoNumbers) {
  Surface sent = random_surface(4);
  sent.modes = {{.shape = Field::Random(2, 4), .mobility = 0.25, .load = -3},
                {.shape = Field::Random(2, 4), .mobility = 0, .load = 0}};
  v1::Motion motion;
  encode_motion(sent, motion);
  Surface received = random_surface(4);
  decode_motion(motion, received);
  ASSERT_EQ(received.modes.size(), 2U);
  EXPECT_EQ(received.modes[0].shape, sent.modes[0].shape);
  EXPECT_EQ(received.modes[0].mobility, 0.25);
  EXPECT_EQ(received.modes[0].load, -3);
  motion.mutable_modes(1)->set_mobility(nan);
  EXPECT_THAT([&] { decode_motion(motion, received); },
              ThrowsMessage<Error>(HasSubstr("a mode has a mobility of nan")));
  sent.modes.clear();
  encode_motion(sent, motion);
  decode_motion(motion, received);
  EXPECT_TRUE(received.modes.empty());
}

TEST(Surface, CarriesTheFrequencyAndRejectsNaNAndNegativeOnes) {
  Surface sent = random_surface(4);
  sent.frequency = 12.5;
  v1::Motion motion;
  encode_motion(sent, motion);
  Surface received = random_surface(4);
  decode_motion(motion, received);
  EXPECT_EQ(received.frequency, 12.5);
  for (const double wrong : {nan, -1.0}) {
    motion.set_frequency(wrong);
    EXPECT_THAT([&] { decode_motion(motion, received); },
                ThrowsMessage<Error>(HasSubstr("must be finite and >= 0")));
  }
}

TEST(Surface, SparesTheRampIncrementWhereItIsZeroAndResetsItOnArrival) {
  Surface sent = random_surface(3);
  sent.ramp_increment.setZero();
  v1::Motion motion;
  encode_motion(sent, motion);
  EXPECT_EQ(motion.ramp_increment_size(), 0);
  Surface received = random_surface(3);
  decode_motion(motion, received);
  EXPECT_TRUE(received.ramp_increment.isZero(0));

  sent.ramp_increment(0, 0) = -0.0;
  encode_motion(sent, motion);
  EXPECT_EQ(motion.ramp_increment_size(), 6);
}

TEST(Surface, NamesTheFieldAndThePointOfANumberThatIsNotFinite) {
  Surface sent = random_surface(30);
  sent.force(1, 17) = nan;
  v1::Load load;
  encode_load(sent, load);
  Surface received = Surface::at_rest(2, 30);
  EXPECT_THAT([&] { decode_load(load, received); }, ThrowsMessage<Error>("force of point 17 is nan"));

  sent = random_surface(30);
  sent.pressure[29] = infinity;
  encode_load(sent, load);
  EXPECT_THAT([&] { decode_load(load, received); }, ThrowsMessage<Error>("pressure of point 29 is inf"));
}

TEST(Surface, OfAnotherLengthIsRefused) {
  v1::Motion motion;
  encode_motion(random_surface(4), motion);
  Surface received = Surface::at_rest(2, 5);
  EXPECT_THAT([&] { decode_motion(motion, received); },
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
  encode(Snapshot{{.name = "velocity", .unit = "m/s", .components = 2, .values = {1, 2, 3, 4}}}, message);
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
  const Identity sent{Role::solid, "solid_solver", "0.1.0", {2, 3}, {"save"}};
  v1::Hello message;
  encode(sent, message);
  const Identity received = decode(message);
  EXPECT_EQ(received.role, Role::solid);
  EXPECT_EQ(received.program, sent.program);
  EXPECT_EQ(received.version, sent.version);
  EXPECT_EQ(received.dimensions, sent.dimensions);
  EXPECT_EQ(received.capabilities, sent.capabilities);
  message.set_role(v1::ROLE_UNSPECIFIED);
  EXPECT_THAT([&] { decode(message); }, ThrowsMessage<Error>("role 0 is neither fluid nor solid"));
}

}  // namespace
}  // namespace cosurge
