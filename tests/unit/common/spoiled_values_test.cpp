// Values out of bounds, of a wrong kind or unknown, key by key: the whole message, soon and without much
// memory.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/case_text.hpp"
#include "tests/support/own_memory.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using testing::errors_of;

struct SpoiledValue {
  const char* key;
  const char* value;
  const char* error;
};

const SpoiledValue values[] = {
    {"schema", "0", "0 must be >= 1"},
    {"time.end", "0", "0 must be > 0 [s]"},
    {"time.end", "-1", "-1 must be > 0 [s]"},
    {"time.window", "0", "0 must be > 0 [s]"},
    {"time.stepping", "free", "must be one of: adaptive, fixed"},
    {"fluid.spacing", "0", "0 must be > 0 [m]"},
    {"fluid.density", "0", "0 must be > 0 [kg/m3]"},
    {"fluid.density", "-1000", "-1000 must be > 0 [kg/m3]"},
    {"fluid.kinematic_viscosity", "-1", "-1 must be >= 0 [m2/s]"},
    {"fluid.gamma", "0", "0 must be > 0 [-]"},
    {"fluid.gamma", "1.5", "1.5 must be <= 1 [-]"},
    {"fluid.compressibility", "0", "0 must be > 0 [1/Pa]"},
    {"fluid.compressibility", "0.001", "0.001 must be <= 0.0001 [1/Pa]"},
    {"fluid.propagation_speed", "0", "0 must be > 0 [m/s]"},
    {"fluid.re_gradient", "1", "1 must be >= 1.5 [l0]"},
    {"fluid.re_gradient", "4.5", "4.5 must be <= 4 [l0]"},
    {"fluid.re_laplacian", "1", "1 must be >= 1.5 [l0]"},
    {"fluid.re_laplacian", "6", "6 must be <= 5 [l0]"},
    {"fluid.courant", "0", "0 must be > 0 [-]"},
    {"fluid.courant", "1.1", "1.1 must be <= 1 [-]"},
    {"fluid.free_surface.beta", "0", "0 must be > 0 [-]"},
    {"fluid.free_surface.beta", "1", "1 must be < 1 [-]"},
    {"fluid.free_surface.delta", "-0.1", "-0.1 must be >= 0 [l0]"},
    {"fluid.free_surface.delta", "1", "1 must be < 1 [l0]"},
    {"fluid.collision.distance", "-0.1", "-0.1 must be >= 0 [l0]"},
    {"fluid.collision.distance", "1", "1 must be < 1 [l0]"},
    {"fluid.collision.restitution", "-0.1", "-0.1 must be >= 0 [-]"},
    {"fluid.collision.restitution", "1.1", "1.1 must be <= 1 [-]"},
    {"fluid.pressure.tolerance", "0", "0 must be > 0 [-]"},
    {"fluid.pressure.tolerance", "1", "1 must be < 1 [-]"},
    {"fluid.pressure.max_iterations", "0", "0 must be > 0"},
    {"fluid.pressure.preconditioner", "ilu", "must be one of: aggregation, jacobi"},
    {"fluid.gradient", "steep", "must be one of: p_min, conserving, corrected"},
    {"fluid.shifting", "-0.1", "-0.1 must be >= 0 [-]"},
    {"fluid.shifting", "2", "2 must be <= 1 [-]"},
    {"fluid.lowest_pressure", "1", "1 must be <= 0 [Pa]"},
    {"fluid.most_lost", "-0.1", "-0.1 must be >= 0 [-]"},
    {"fluid.most_lost", "2", "2 must be <= 1 [-]"},
    {"solid.model", "beam", "must be one of: mps, rigid, fem, modal, hamiltonian, sprung, auto"},
    {"solid.spacing", "0", "0 must be > 0 [m]"},
    {"solid.density", "-1", "-1 must be > 0 [kg/m3]"},
    {"solid.young_modulus", "0", "0 must be > 0 [Pa]"},
    {"solid.poisson_ratio", "-0.1", "-0.1 must be >= 0 [-]"},
    {"solid.poisson_ratio", "0.7", "0.7 must be < 0.5 [-]"},
    {"solid.material", "steel", "must be one of: st_venant_kirchhoff, neo_hookean"},
    {"solid.plane", "plain", "must be one of: plane_strain, plane_stress"},
    {"solid.damping_ratio", "-0.1", "-0.1 must be >= 0 [-]"},
    {"solid.damping_ratio", "1", "1 must be < 1 [-]"},
    {"solid.mps.re", "1", "1 must be >= 1.5 [l0]"},
    {"solid.mps.re", "4", "4 must be <= 3.5 [l0]"},
    {"solid.mps.step_fraction", "0", "0 must be > 0 [-]"},
    {"solid.mps.step_fraction", "1.5", "1.5 must be <= 1 [-]"},
    {"solid.mps.substep", "0", "0 must be > 0 [s]"},
    {"solid.mps.viscosity", "-1", "-1 must be >= 0 [-]"},
    {"solid.mps.viscosity", "3", "3 must be <= 2 [-]"},
    {"solid.hamiltonian.re", "1", "1 must be >= 1.5 [l0]"},
    {"solid.hamiltonian.re", "4", "4 must be <= 3.5 [l0]"},
    {"solid.hamiltonian.step_fraction", "0", "0 must be > 0 [-]"},
    {"solid.hamiltonian.step_fraction", "1.5", "1.5 must be <= 1 [-]"},
    {"solid.hamiltonian.substep", "0", "0 must be > 0 [s]"},
    {"solid.hamiltonian.viscosity", "-1", "-1 must be >= 0 [-]"},
    {"solid.hamiltonian.viscosity", "3", "3 must be <= 2 [-]"},
    {"solid.mps.pairs", "none_at_all", "must be one of: corrected, paper"},
    {"solid.hamiltonian.stabilisation", "-1", "-1 must be >= 0 [-]"},
    {"solid.hamiltonian.stabilisation", "11", "11 must be <= 10 [-]"},
    {"solid.fem.element", "0", "0 must be > 0 [m]"},
    {"solid.fem.rho_infinity", "-0.1", "-0.1 must be >= 0 [-]"},
    {"solid.fem.rho_infinity", "1.1", "1.1 must be <= 1 [-]"},
    {"solid.fem.substep", "0", "0 must be > 0 [s]"},
    {"solid.modal.modes", "0", "0 must be >= 1"},
    {"solid.modal.modes", "1001", "1001 must be <= 1000"},
    {"coupling.scheme", "strongest", "must be one of: weak, strong, weak_inertial, auto, strong_inertial"},
    {"coupling.load", "thrown", "must be one of: held, ramped"},
    {"coupling.velocity", "start", "must be one of: mean, end"},
    {"coupling.prediction", "first", "must be one of: last, extrapolated"},
    {"coupling.modes", "0", "0 must be >= 1"},
    {"coupling.modes", "51", "51 must be <= 50"},
    {"coupling.iteration.relaxation", "none_at_all", "must be one of: constant, aitken, iqn_ils"},
    {"coupling.iteration.tolerance", "0", "0 must be > 0 [-]"},
    {"coupling.iteration.tolerance", "1", "1 must be < 1 [-]"},
    {"coupling.iteration.limit", "1", "1 must be >= 2"},
    {"coupling.iteration.limit", "1001", "1001 must be <= 1000"},
    {"coupling.iteration.factor", "0", "0 must be > 0 [-]"},
    {"coupling.iteration.factor", "1.5", "1.5 must be <= 1 [-]"},
    {"coupling.iteration.reuse", "-1", "-1 must be >= 0"},
    {"coupling.iteration.reuse", "101", "101 must be <= 100"},
    {"output.frame_interval", "0", "0 must be > 0 [s]"},
    {"output.probe.0.quantity", "weight", "must be one of: pressure, displacement, level, force, moment"},
    {"output.probe.0.position", "[0.1]", "has 1 components, must have 2"},
    {"gravity", "9.81", "must be a list"},
    {"fluid.tank.min", "0", "must be a list"},
    {"title", "3", "must be a text in quotes"},
    {"fluid.tank.height", "1", "unknown key, allowed: min, max"},
    {"coupling.weak", "true", "unknown key, allowed: scheme, load, velocity, prediction, iteration, modes"},
    {"time.step", "1e-3", "unknown key, allowed: end, window, stepping"},
};

class SpoiledValues : public ::testing::TestWithParam<SpoiledValue> {};

TEST_P(SpoiledValues, AreRefusedWithTheWholeMessage) {
  const auto& [key, value, error] = GetParam();
  const CaseText text;
  const double before = testing::own_memory();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(errors_of(text.file(), {fmt::format("{}={}", key, value)}),
            fmt::format("--set {0}={1}: {0}: {2}", key, value, error));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  if (testing::memory_can_be_measured) {
    EXPECT_LT(testing::own_memory() - before, 100e3);  // kB
  }
}

std::string test_name(const ::testing::TestParamInfo<SpoiledValue>& test) {
  std::string name = fmt::format("{}_{}", test.param.key, test.index);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(CaseRules, SpoiledValues, ::testing::ValuesIn(values), test_name);

}  // namespace
}  // namespace cosurge
