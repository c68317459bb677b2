// Participants without physics of their own, for tests of the protocol and of coupling schemes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/participant.hpp"
#include "proto/case.pb.h"

namespace cosurge::testing {

/// Base of mocks. All data that change during a run must be in `state`, which save() and restore() copy.
class MockParticipant : public virtual Participant {
 public:
  explicit MockParticipant(const std::string& program) : who{program, "0.1.0", {2, 3}, {"save", "frame"}} {}

  Identity who;
  std::vector<double> state;
  std::vector<double> remembered;  // state at the start of a window that may be repeated
  std::function<void()> on_finalize = [] {};

  Identity identity() const override { return who; }
  std::string save() override {
    return {reinterpret_cast<const char*>(state.data()), state.size() * sizeof(double)};
  }
  void restore(const std::string& bytes) override {
    require(bytes.size() == state.size() * sizeof(double), "a state of {} bytes instead of {}", bytes.size(),
            state.size() * sizeof(double));
    std::memcpy(state.data(), bytes.data(), bytes.size());
  }
  Snapshot frame() override {
    return {{.name = "state", .unit = "-", .components = 1, .values = {state.begin(), state.end()}}};
  }
  void finalize() override { on_finalize(); }

 protected:
  void enter(const Window& window) {
    if (window.attempt == Attempt::first) remembered = state;
    if (window.attempt == Attempt::again) std::copy(remembered.begin(), remembered.end(), state.begin());
  }
};

/// Every call can be replaced.
class MockFluid : public Fluid, public MockParticipant {
 public:
  MockFluid() : MockParticipant("mock_fluid") {}

  std::function<Setup(const v1::Case&, Interface&, InterfaceLoad&)> on_initialize;
  std::function<Report(const Window&, const InterfaceMotion&, InterfaceLoad&)> on_advance;

  Setup initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) override {
    return on_initialize(the_case, interface, load);
  }
  Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) override {
    enter(window);
    return on_advance(window, motion, load);
  }
};

/// The same for a structure.
class MockSolid : public Solid, public MockParticipant {
 public:
  MockSolid() : MockParticipant("mock_solid") {}

  std::function<Setup(const v1::Case&, const Interface&, const InterfaceLoad&, InterfaceMotion&)>
      on_initialize;
  std::function<Report(const Window&, const InterfaceLoad&, InterfaceMotion&)> on_advance;

  Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                   InterfaceMotion& motion) override {
    return on_initialize(the_case, interface, load, motion);
  }
  Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) override {
    enter(window);
    return on_advance(window, load, motion);
  }
};

/// A column of incompressible water on a piston of unit area, the test bed with an exact answer: the added
/// mass is density * height, the angular frequency sqrt(stiffness / (mass + density * height)).
struct Piston {
  double mass = 1000;         // per area [kg/m2]
  double stiffness = 1e5;     // per area [N/m3]
  double density = 1000;      // density of the water [kg/m3]
  double height = 0.5;        // height of the column [m]
  double gravity = 9.81;      // [m/s2]
  int points = 5;             // number of points that share the area
  int substeps = 10;          // sub-steps of the solid in a window
  bool tells_mode = false;    // whether it sends its mode, for schemes that include its added mass
  bool ramped = false;        // load over a window
  bool end_velocity = false;  // the water gets the velocity at the end, not the mean

  double added_mass() const { return density * height; }
  double wet_frequency() const {  // [Hz]
    return std::sqrt(stiffness / (mass + added_mass())) / (2 * std::numbers::pi);
  }
};

/// The water: pressure density * height * (gravity + a), where a is the piston's acceleration, from the
/// change of its mean velocity from window to window. State: the last mean velocity.
inline std::unique_ptr<MockFluid> water_column(const Piston& piston) {
  auto fluid = std::make_unique<MockFluid>();
  fluid->state = {0};
  fluid->on_initialize = [piston](const v1::Case& the_case, Interface& interface, InterfaceLoad& load) {
    const int dimension = the_case.dimension();
    interface = {.dimension = dimension,
                 .position = Field::Zero(dimension, piston.points),
                 .area = Field::Zero(dimension, piston.points),
                 .body = std::vector<int>(static_cast<std::size_t>(piston.points), 0)};
    interface.position.row(0).setLinSpaced(0.5 / piston.points, 1 - 0.5 / piston.points);
    interface.area.row(1).setConstant(1.0 / piston.points);
    load = InterfaceLoad::zero(dimension, piston.points);
    return Setup{.columns = {{"pressure", "Pa"}}, .particles = 1, .window = 1, .substep = 0};
  };
  fluid->on_advance = [piston, &last = fluid->state[0]](const Window& window, const InterfaceMotion& motion,
                                                        InterfaceLoad& load) {
    const double velocity = motion.velocity.row(1).mean();
    double pressure = piston.added_mass() * (piston.gravity + (velocity - last) / window.size);
    last = velocity;
    for (const Mode& mode : motion.modes) {  // one at most: f = f0 - m_a s (f - load) / dt
      const double answer = piston.added_mass() * mode.mobility / window.size;
      const double of_mode = (-pressure + answer * mode.load) / (1 + answer);
      last = velocity + mode.mobility * (of_mode - mode.load);
      pressure = -of_mode;
    }
    load.pressure.setConstant(pressure);
    load.force.row(1).setConstant(-pressure / piston.points);
    return Report{.values = {pressure}, .window = 1};
  };
  return fluid;
}

/// The piston: sub-cycles of symplectic Euler under the load of the window. State: height, velocity, and the
/// load of the last window.
inline std::unique_ptr<MockSolid> sprung_piston(const Piston& piston) {
  auto solid = std::make_unique<MockSolid>();
  solid->state = {0, 0, 0};
  solid->on_initialize = [](const v1::Case& the_case, const Interface& interface, const InterfaceLoad&,
                            InterfaceMotion& motion) {
    motion = InterfaceMotion::at_rest(the_case.dimension(), interface.points());
    return Setup{.columns = {{"height", "m"}}, .particles = 1, .window = 1, .substep = 0};
  };
  solid->on_advance = [piston, &y = solid->state[0], &v = solid->state[1], &last = solid->state[2]](
                          const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
    const double before = y;
    const double dt = window.size / piston.substeps;
    const double force = load.force.row(1).sum();
    double late = 0;
    for (int k = 0; k < piston.substeps; ++k) {
      const double s = (k + 0.5) / piston.substeps;
      const double now = piston.ramped ? last + s * (force - last) : force;
      v += dt * (now - piston.stiffness * y) / piston.mass;
      y += dt * v;
      late += s * dt * v;
    }
    last = force;
    motion.displacement.row(1).setConstant(y);
    motion.velocity.row(1).setConstant(piston.end_velocity ? v : (y - before) / window.size);
    motion.ramp_increment.row(1).setConstant(piston.ramped ? late : 0);
    motion.modes.clear();
    if (piston.tells_mode && window.attempt == Attempt::first) {
      Field shape = Field::Zero(motion.velocity.rows(), motion.velocity.cols());
      shape.row(1).setOnes();
      motion.modes.push_back({.shape = shape, .mobility = window.size / piston.mass, .load = force});
    }
    return Report{.values = {y}, .window = 1};
  };
  return solid;
}

/// The keys of a case that the mocks use, and all that the schema requires.
inline v1::Case piston_case() {
  v1::Case the_case;
  the_case.set_title("piston");
  the_case.mutable_time()->set_end(1);
  the_case.mutable_time()->set_window(1e-3);
  the_case.mutable_solid()->set_density(1000);
  the_case.mutable_solid()->set_young_modulus(1e6);
  the_case.mutable_solid()->add_body()->mutable_box();
  return the_case;
}

}  // namespace cosurge::testing
