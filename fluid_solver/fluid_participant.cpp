#include "fluid_solver/fluid_participant.hpp"

#include "common/case/from_case.hpp"
#include "common/case/window_sizes.hpp"
#include "common/solvers.hpp"
#include "common/version.hpp"
#include "fluid_solver/from_case.hpp"
#include "fluid_solver/gauges.hpp"
#include "fluid_solver/lost_water.hpp"
#include "fluid_solver/mps.hpp"
#include "fluid_solver/probes.hpp"

namespace cosurge::fluid {

/// A scene of either dimension.
class FluidParticipant::Scene {
 public:
  virtual ~Scene() = default;
  virtual Setup describe(Interface& interface, InterfaceLoad& load) = 0;
  virtual Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) = 0;
  virtual std::string save() = 0;
  virtual void restore(const std::string& state) = 0;
  virtual Snapshot frame() = 0;
};

template <int dim>
class FluidParticipant::SceneOf : public Scene {
 public:
  explicit SceneOf(const v1::Case& the_case)
      : water_(water_from_case(the_case.fluid(), from_case<dim>(the_case.gravity()))),
        longest_window_(longest_window(the_case)),
        mps_(water_, bodies_from_case<dim>(the_case)),
        lost_water_(water_, mps_.particles()),
        probes_(probes_from_case<dim>(the_case), mps_, mps_.bodies().interface()) {}

  Setup describe(Interface& interface, InterfaceLoad& load) override {
    interface = mps_.bodies().interface();
    load = InterfaceLoad::zero(dim, interface.points());
    Setup setup{.columns = {{"ppe_iterations", "-"},
                            {"ppe_residual", "-"},
                            {"ppe_unknowns", "-"},
                            {"modes_iterations", "-"},
                            {"modes_mass_ratio", "-"},
                            {"max_speed", "m/s"},
                            {"kinetic_energy", "J"},
                            {"gravity_energy", "J"},
                            {"front", "m"},
                            {"lost", "-"},
                            {"inside_bodies", "-"},
                            {"seconds_predict", "s"},
                            {"seconds_neighbors", "s"},
                            {"seconds_density", "s"},
                            {"seconds_ppe_assembly", "s"},
                            {"seconds_ppe_solve", "s"},
                            {"seconds_gradient", "s"},
                            {"cpu_seconds", "s"}},
                .particles = static_cast<std::uint64_t>(mps_.initial_size()),
                .window = mps_.first_window(longest_window_),
                .substep = 0};
    for (const Column& column : LostWater<dim>::columns()) setup.columns.push_back(column);
    for (const Column& column : probes_.columns()) setup.columns.push_back(column);
    return setup;
  }

  Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) override {
    const bool repeated = window.attempt == Attempt::again;
    if (repeated)
      mps_.set_body_velocity(motion.velocity);
    else
      mps_.move_bodies(motion.displacement, motion.velocity);
    mps_.set_modes(motion.modes);
    mps_.set_frequency(motion.frequency);
    if (!repeated) lost_water_.before_step(mps_.particles());
    const StepReport step = mps_.step(window.start, window.size, window.attempt);
    if (!repeated) lost_water_.after_step(mps_.particles(), window.start + window.size);
    mps_.load(load);
    const WaterState water = survey_water(mps_, particle_mass(), water_.spacing, water_.gravity);
    Report report;
    report.values = {static_cast<double>(step.pressure.iterations),
                     step.pressure.relative_residual,
                     static_cast<double>(mps_.unknowns()),
                     static_cast<double>(mps_.added_mass().iterations()),
                     mps_.added_mass().ratio(),
                     step.max_speed,
                     water.kinetic_energy,
                     water.gravity_energy,
                     water.front,
                     static_cast<double>(mps_.initial_size() - mps_.particles().size()),
                     static_cast<double>(water.inside_bodies)};
    for (const double seconds : mps_.clock().seconds()) report.values.push_back(seconds);
    report.values.push_back(cpu_seconds() - cpu_start_);
    for (const double value : lost_water_.values()) report.values.push_back(value);
    for (const double value :
         probes_.read({.motion = motion, .load = load, .end = window.start + window.size}))
      report.values.push_back(value);
    report.window = step.max_window;
    return report;
  }

  std::string save() override {
    StateWriter state;
    state.put(mps_.save());
    lost_water_.save(state);
    return state.take();
  }

  void restore(const std::string& bytes) override {
    StateReader state(bytes);
    std::string water;
    state.get(water);
    mps_.restore(water);
    lost_water_.restore(state);
    state.finish();
  }

  Snapshot frame() override {
    const auto count = static_cast<std::size_t>(mps_.initial_size());
    Array position{"position", "m", dim, std::vector<float>(dim * count)};
    Array velocity{"velocity", "m/s", dim, std::vector<float>(dim * count)};
    Array pressure{"pressure", "Pa", 1, std::vector<float>(count)};
    Array density{"number_density", "n0", 1, std::vector<float>(count)};
    Array kind{"kind", "-", 1, std::vector<float>(count, lost_kind)};
    const Particles<dim>& particles = mps_.particles();
    for (int i = 0; i < particles.size(); ++i) {
      const auto id = static_cast<std::size_t>(particles.id[i]);
      for (int k = 0; k < dim; ++k) {
        position.values[dim * id + k] = static_cast<float>(particles.x[i][k]);
        velocity.values[dim * id + k] = static_cast<float>(particles.u[i][k]);
      }
      pressure.values[id] = static_cast<float>(particles.p[i]);
      density.values[id] = static_cast<float>(particles.n[i] / mps_.n0());
      kind.values[id] = static_cast<float>(particles.kind[i]);
    }
    Snapshot arrays;  // a list in braces would copy them
    for (Array* array : {&position, &velocity, &pressure, &density, &kind})
      arrays.push_back(std::move(*array));
    return arrays;
  }

 private:
  static constexpr float lost_kind = 5;  // kind of a particle that has left the domain; it lies at the origin

  double particle_mass() const { return water_.density * std::pow(water_.spacing, dim); }

  Water<dim> water_;
  double longest_window_;  // longest window that the case allows [s]
  Mps<dim> mps_;
  LostWater<dim> lost_water_;
  Probes<dim> probes_;
  double cpu_start_ = cpu_seconds();
};

FluidParticipant::FluidParticipant() = default;
FluidParticipant::~FluidParticipant() = default;

Identity FluidParticipant::identity() const {
  return {
      .program = "fluid_solver", .version = version, .dimensions = {2, 3}, .capabilities = {"save", "frame"}};
}

Setup FluidParticipant::initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) {
  if (the_case.dimension() == 2)
    scene_ = std::make_unique<SceneOf<2>>(the_case);
  else
    scene_ = std::make_unique<SceneOf<3>>(the_case);
  return scene_->describe(interface, load);
}

Report FluidParticipant::advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) {
  return scene_->advance(window, motion, load);
}
std::string FluidParticipant::save() { return scene_->save(); }
void FluidParticipant::restore(const std::string& state) { scene_->restore(state); }
Snapshot FluidParticipant::frame() { return scene_->frame(); }

}  // namespace cosurge::fluid

std::unique_ptr<cosurge::Fluid> cosurge::make_fluid_solver() {
  return std::make_unique<fluid::FluidParticipant>();
}
