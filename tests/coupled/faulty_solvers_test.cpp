// Solvers that send something wrong, at every phase of the protocol, and the message that follows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "tests/support/scripted_solver.hpp"

namespace cosurge::testing {
namespace {

using R = v1::Reply;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// One answer of a right solver, what is wrong in it, and the message of the coupler.
struct Faulty {
  const char* name;
  Role role;
  Phase phase;
  void (*spoil)(R&);
  const char* error;
};

constexpr Role F = Role::fluid, S = Role::solid;

const Faulty faults[] = {
    // Hello
    {"OtherProtocol", F, Phase::hello, [](R& r) { r.mutable_hello()->set_protocol(3); },
     "mock_fluid 0.1.0: refused: it uses protocol 3, the coupler uses 2"},
    {"NoProtocol", S, Phase::hello, [](R& r) { r.mutable_hello()->clear_protocol(); },
     "mock_solid 0.1.0: refused: it uses protocol 0, the coupler uses 2"},
    {"NoRole", F, Phase::hello, [](R& r) { r.mutable_hello()->clear_role(); },
     "mock_fluid 0.1.0: refused: role 0 is neither fluid nor solid"},
    {"UnknownRole", F, Phase::hello, [](R& r) { r.mutable_hello()->set_role(static_cast<v1::Role>(7)); },
     "mock_fluid 0.1.0: refused: role 7 is neither fluid nor solid"},
    {"SolidForFluid", F, Phase::hello, [](R& r) { r.mutable_hello()->set_role(v1::SOLID); },
     "mock_fluid 0.1.0: refused: it is a solid solver, a fluid solver is expected"},
    {"FluidForSolid", S, Phase::hello, [](R& r) { r.mutable_hello()->set_role(v1::FLUID); },
     "mock_solid 0.1.0: refused: it is a fluid solver, a solid solver is expected"},
    {"OtherToken", F, Phase::hello, [](R& r) { r.mutable_hello()->set_token("none"); },
     "mock_fluid 0.1.0: refused: it has the token of another run"},
    {"NoToken", S, Phase::hello, [](R& r) { r.mutable_hello()->clear_token(); },
     "mock_solid 0.1.0: refused: it has the token of another run"},
    {"NoDimensions", F, Phase::hello, [](R& r) { r.mutable_hello()->clear_dimensions(); },
     "mock_fluid 0.1.0: refused: it does not support 2 dimensions"},
    {"OtherDimensions", S, Phase::hello, [](R& r) { r.mutable_hello()->set_dimensions(0, 4); },
     "mock_solid 0.1.0: refused: it does not support 2 dimensions"},
    {"NoCapabilities", F, Phase::hello, [](R& r) { r.mutable_hello()->clear_capabilities(); },
     "mock_fluid 0.1.0: refused: it does not support \"save\""},
    {"ACapabilityTooFew", S, Phase::hello,
     [](R& r) { r.mutable_hello()->mutable_capabilities()->RemoveLast(); },
     "mock_solid 0.1.0: refused: it does not support \"frame\""},
    {"HelloWithANumber", F, Phase::hello, [](R& r) { r.set_sequence(1); },
     "the fluid solver: refused: its first message is not a hello"},
    {"LongHello", F, Phase::hello, [](R& r) { r.mutable_hello()->set_version(std::string(70000, 'x')); },
     "the fluid solver: refused: a message of 70059 bytes exceeds the limit of 65536"},
    {"FailureForHello", S, Phase::hello, [](R& r) { r.mutable_failure()->set_what("no \x1b[31mlicence"); },
     "the solid solver: refused: no ?[31mlicence"},

    // Initialize
    {"NoInterface", F, Phase::initialize, [](R& r) { r.mutable_initialized()->clear_interface(); },
     "mock_fluid 0.1.0: the interface has 0 dimensions, the case 2 [initialize]"},
    {"InterfaceOfThreeDimensions", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->set_dimension(3); },
     "mock_fluid 0.1.0: the interface has 3 dimensions, the case 2 [initialize]"},
    {"ShortPosition", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->mutable_position()->RemoveLast(); },
     "mock_fluid 0.1.0: position has 9 numbers instead of 2 x 5 [initialize]"},
    {"LongArea", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->add_area(1); },
     "mock_fluid 0.1.0: area has 11 numbers instead of 2 x 5 [initialize]"},
    {"PositionIsNotANumber", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->set_position(7, nan); },
     "mock_fluid 0.1.0: position of point 3 is nan [initialize]"},
    {"InfiniteArea", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->set_area(0, -inf); },
     "mock_fluid 0.1.0: area of point 0 is -inf [initialize]"},
    {"APointMore", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->add_body(0); },
     "mock_fluid 0.1.0: position has 10 numbers instead of 2 x 6 [initialize]"},
    {"NegativeBody", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->set_body(2, -1); },
     "mock_fluid 0.1.0: a point of the interface lies on body -1 of 1 [initialize]"},
    {"BodyThatDoesNotExist", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_interface()->set_body(4, 1); },
     "mock_fluid 0.1.0: a point of the interface lies on body 1 of 1 [initialize]"},
    {"NoInitialLoad", F, Phase::initialize, [](R& r) { r.mutable_initialized()->clear_load(); },
     "mock_fluid 0.1.0: force has 0 numbers instead of 2 x 5 [initialize]"},
    {"ShortInitialPressure", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_load()->mutable_pressure()->RemoveLast(); },
     "mock_fluid 0.1.0: pressure has 4 numbers instead of 5 x 1 [initialize]"},
    {"InitialForceIsNotANumber", F, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_load()->set_force(9, nan); },
     "mock_fluid 0.1.0: force of point 4 is nan [initialize]"},
    {"NoFirstWindow", F, Phase::initialize, [](R& r) { r.mutable_initialized()->clear_window(); },
     "mock_fluid 0.1.0: the largest window is 0 s, must be > 0 [initialize]"},
    {"NegativeFirstWindow", S, Phase::initialize, [](R& r) { r.mutable_initialized()->set_window(-1e-3); },
     "mock_solid 0.1.0: the largest window is -0.001 s, must be > 0 [initialize]"},
    {"FirstWindowIsNotANumber", S, Phase::initialize, [](R& r) { r.mutable_initialized()->set_window(nan); },
     "mock_solid 0.1.0: the largest window is nan s, must be > 0 [initialize]"},
    {"NegativeSubstep", S, Phase::initialize, [](R& r) { r.mutable_initialized()->set_substep(-1); },
     "mock_solid 0.1.0: the sub-step is -1 s, must be >= 0 [initialize]"},
    {"InfiniteSubstep", S, Phase::initialize, [](R& r) { r.mutable_initialized()->set_substep(inf); },
     "mock_solid 0.1.0: the sub-step is inf s, must be >= 0 [initialize]"},
    {"VeryManyColumns", F, Phase::initialize,
     [](R& r) {
       for (int k = 0; k < 10000; ++k) r.mutable_initialized()->add_columns()->set_name("c");
     },
     "mock_fluid 0.1.0: 10001 columns, must be <= 10000 [initialize]"},
    {"ColumnWithoutAName", F, Phase::initialize, [](R& r) { r.mutable_initialized()->add_columns(); },
     "mock_fluid 0.1.0: the name of a column is \"\": it must have 1 to 100 characters, and no slash "
     "[initialize]"},
    {"ColumnInAnotherGroup", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->add_columns()->set_name("../time"); },
     "mock_solid 0.1.0: the name of a column is \"../time\": it must have 1 to 100 characters, and no slash "
     "[initialize]"},
    {"ColumnThatWritesToATerminal", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->add_columns()->set_name("a\x1b[2J"); },
     "mock_solid 0.1.0: the name of a column is \"a?[2J\": it must have 1 to 100 characters, and no slash "
     "[initialize]"},
    {"ColumnCalledAsTheFolderAbove", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->add_columns()->set_name(".."); },
     "mock_solid 0.1.0: the name of a column is \"..\": it must have 1 to 100 characters, and no slash "
     "[initialize]"},
    {"NoInitialMotion", S, Phase::initialize, [](R& r) { r.mutable_initialized()->clear_motion(); },
     "mock_solid 0.1.0: displacement has 0 numbers instead of 2 x 5 [initialize]"},
    {"ShortInitialVelocity", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_motion()->mutable_velocity()->RemoveLast(); },
     "mock_solid 0.1.0: velocity has 9 numbers instead of 2 x 5 [initialize]"},
    {"InfiniteInitialDisplacement", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_motion()->set_displacement(1, inf); },
     "mock_solid 0.1.0: displacement of point 0 is inf [initialize]"},
    {"NegativeFrequency", S, Phase::initialize,
     [](R& r) { r.mutable_initialized()->mutable_motion()->set_frequency(-2); },
     "mock_solid 0.1.0: frequency is -2 rad/s, must be finite and >= 0 [initialize]"},

    // Advance
    {"NoLoad", F, Phase::advance, [](R& r) { r.mutable_advanced()->clear_load(); },
     "mock_fluid 0.1.0: force has 0 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"MotionForLoad", F, Phase::advance, [](R& r) { r.mutable_advanced()->mutable_motion(); },
     "mock_fluid 0.1.0: force has 0 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"ShortForce", F, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_load()->mutable_force()->RemoveLast(); },
     "mock_fluid 0.1.0: force has 9 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"LongForce", F, Phase::advance, [](R& r) { r.mutable_advanced()->mutable_load()->add_force(0); },
     "mock_fluid 0.1.0: force has 11 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"ForceIsNotANumber", F, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_load()->set_force(3, nan); },
     "mock_fluid 0.1.0: force of point 1 is nan [advance, window 0 (t = 0 s)]"},
    {"InfiniteForce", F, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_load()->set_force(0, inf); },
     "mock_fluid 0.1.0: force of point 0 is inf [advance, window 0 (t = 0 s)]"},
    {"ShortPressure", F, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_load()->mutable_pressure()->RemoveLast(); },
     "mock_fluid 0.1.0: pressure has 4 numbers instead of 5 x 1 [advance, window 0 (t = 0 s)]"},
    {"NoPressure", F, Phase::advance, [](R& r) { r.mutable_advanced()->mutable_load()->clear_pressure(); },
     "mock_fluid 0.1.0: pressure has 0 numbers instead of 5 x 1 [advance, window 0 (t = 0 s)]"},
    {"PressureIsNotANumber", F, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_load()->set_pressure(4, -nan); },
     "mock_fluid 0.1.0: pressure of point 4 is -nan [advance, window 0 (t = 0 s)]"},
    {"NoValues", F, Phase::advance, [](R& r) { r.mutable_advanced()->clear_values(); },
     "mock_fluid 0.1.0: 0 values reported instead of 1 [advance, window 0 (t = 0 s)]"},
    {"AValueMore", S, Phase::advance, [](R& r) { r.mutable_advanced()->add_values(1); },
     "mock_solid 0.1.0: 2 values reported instead of 1 [advance, window 0 (t = 0 s)]"},
    {"ValueIsNotANumber", S, Phase::advance, [](R& r) { r.mutable_advanced()->set_values(0, nan); },
     "mock_solid 0.1.0: reported value 0 is nan [advance, window 0 (t = 0 s)]"},
    {"InfiniteValue", F, Phase::advance, [](R& r) { r.mutable_advanced()->set_values(0, inf); },
     "mock_fluid 0.1.0: reported value 0 is inf [advance, window 0 (t = 0 s)]"},
    {"NoNextWindow", F, Phase::advance, [](R& r) { r.mutable_advanced()->clear_window(); },
     "mock_fluid 0.1.0: the largest window is 0 s, must be > 0 [advance, window 0 (t = 0 s)]"},
    {"NegativeNextWindow", S, Phase::advance, [](R& r) { r.mutable_advanced()->set_window(-inf); },
     "mock_solid 0.1.0: the largest window is -inf s, must be > 0 [advance, window 0 (t = 0 s)]"},
    {"NextWindowIsNotANumber", S, Phase::advance, [](R& r) { r.mutable_advanced()->set_window(nan); },
     "mock_solid 0.1.0: the largest window is nan s, must be > 0 [advance, window 0 (t = 0 s)]"},
    {"VeryManyNotes", F, Phase::advance,
     [](R& r) {
       for (int k = 0; k < 101; ++k) r.mutable_advanced()->add_notes("look");
     },
     "mock_fluid 0.1.0: 101 notes on one window, must be <= 100 [advance, window 0 (t = 0 s)]"},
    {"NoMotion", S, Phase::advance, [](R& r) { r.mutable_advanced()->clear_motion(); },
     "mock_solid 0.1.0: displacement has 0 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"LongDisplacement", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->add_displacement(0); },
     "mock_solid 0.1.0: displacement has 11 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"DisplacementIsNotANumber", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->set_displacement(2, nan); },
     "mock_solid 0.1.0: displacement of point 1 is nan [advance, window 0 (t = 0 s)]"},
    {"NoVelocity", S, Phase::advance, [](R& r) { r.mutable_advanced()->mutable_motion()->clear_velocity(); },
     "mock_solid 0.1.0: velocity has 0 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"InfiniteVelocity", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->set_velocity(9, -inf); },
     "mock_solid 0.1.0: velocity of point 4 is -inf [advance, window 0 (t = 0 s)]"},
    {"ShortRampIncrement", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->add_ramp_increment(1); },
     "mock_solid 0.1.0: ramp_increment has 1 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"InfiniteFrequency", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->set_frequency(inf); },
     "mock_solid 0.1.0: frequency is inf rad/s, must be finite and >= 0 [advance, window 0 (t = 0 s)]"},
    {"ModeWithoutAShape", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->add_modes()->set_mobility(1); },
     "mock_solid 0.1.0: shape of a mode has 0 numbers instead of 2 x 5 [advance, window 0 (t = 0 s)]"},
    {"ModeOfNegativeMobility", S, Phase::advance,
     [](R& r) {
       auto* mode = r.mutable_advanced()->mutable_motion()->add_modes();
       mode->mutable_shape()->Resize(10, 1);
       mode->set_mobility(-1);
     },
     "mock_solid 0.1.0: a mode has a mobility of -1 and a load of 0 [advance, window 0 (t = 0 s)]"},
    {"ModeWhoseLoadIsNotANumber", S, Phase::advance,
     [](R& r) {
       auto* mode = r.mutable_advanced()->mutable_motion()->add_modes();
       mode->mutable_shape()->Resize(10, 1);
       mode->set_load(nan);
     },
     "mock_solid 0.1.0: a mode has a mobility of 0 and a load of nan [advance, window 0 (t = 0 s)]"},
    {"ModeWhoseShapeIsNotANumber", S, Phase::advance,
     [](R& r) { r.mutable_advanced()->mutable_motion()->add_modes()->mutable_shape()->Resize(10, nan); },
     "mock_solid 0.1.0: shape of a mode of point 0 is nan [advance, window 0 (t = 0 s)]"},
    {"VeryManyModes", S, Phase::advance,
     [](R& r) {
       for (int k = 0; k < 1001; ++k) r.mutable_advanced()->mutable_motion()->add_modes();
     },
     "mock_solid 0.1.0: 1001 modes, must be <= 1000 [advance, window 0 (t = 0 s)]"},
    {"NumericalFailure", F, Phase::advance,
     [](R& r) {
       r.mutable_failure()->set_what("the pressure diverges at t = 0.1 s");
       r.mutable_failure()->set_numerical(true);
     },
     "mock_fluid 0.1.0: the pressure diverges at t = 0.1 s"},

    // Save, frame, restore, finalize
    {"OversizedState", F, Phase::save, [](R& r) { r.mutable_saved()->set_state(std::string(1000000, 'x')); },
     "mock_fluid 0.1.0: a message of 1000019 bytes exceeds the limit of 1000000 [save]"},
    {"VeryManyArrays", F, Phase::frame,
     [](R& r) {
       for (int k = 0; k < 100; ++k) r.mutable_snapshot()->add_arrays();
     },
     "mock_fluid 0.1.0: 101 arrays in a frame, must be <= 100 [frame]"},
    {"ArrayWithoutAName", S, Phase::frame,
     [](R& r) { r.mutable_snapshot()->mutable_arrays(0)->clear_name(); },
     "mock_solid 0.1.0: the name of an array is \"\": it must have 1 to 100 characters, and no slash "
     "[frame]"},
    {"ArrayInAnotherGroup", S, Phase::frame,
     [](R& r) { r.mutable_snapshot()->mutable_arrays(0)->set_name("/history/time"); },
     "mock_solid 0.1.0: the name of an array is \"/history/time\": it must have 1 to 100 characters, and no "
     "slash [frame]"},
    {"ArrayWithoutComponents", F, Phase::frame,
     [](R& r) { r.mutable_snapshot()->mutable_arrays(0)->clear_components(); },
     "mock_fluid 0.1.0: array state of a frame has 1 numbers of 0 components [frame]"},
    {"ArrayOfTenComponents", F, Phase::frame,
     [](R& r) { r.mutable_snapshot()->mutable_arrays(0)->set_components(10); },
     "mock_fluid 0.1.0: array state of a frame has 1 numbers of 10 components [frame]"},
    {"ArrayThatIsCut", S, Phase::frame,
     [](R& r) { r.mutable_snapshot()->mutable_arrays(0)->set_components(2); },
     "mock_solid 0.1.0: array state of a frame has 3 numbers of 2 components [frame]"},
    {"ArrayIsNotANumber", S, Phase::frame,
     [](R& r) {
       r.mutable_snapshot()->mutable_arrays(0)->set_values(2, std::numeric_limits<float>::infinity());
     },
     "mock_solid 0.1.0: state of particle 2 is not finite [frame]"},
    {"LongDoneOfRestore", S, Phase::restore,
     [](R& r) { r.mutable_failure()->set_what(std::string(70000, 'x')); },
     "mock_solid 0.1.0: a message of 70010 bytes exceeds the limit of 65536 [restore]"},
};

class FaultySolvers : public ::testing::TestWithParam<Faulty> {};

TEST_P(FaultySolvers, AreNamedWithWhatIsWrongAndWhere) {
  const Faulty& fault = GetParam();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(error_of_coupler(fault.role, fault.phase, fault.spoil), fault.error);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

INSTANTIATE_TEST_SUITE_P(Protocol, FaultySolvers, ::testing::ValuesIn(faults),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace cosurge::testing
