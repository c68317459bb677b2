#include "fluid_solver/probes.hpp"

#include "fluid_solver/body_load.hpp"
#include "fluid_solver/gauges.hpp"
#include "fluid_solver/wall_load.hpp"

namespace cosurge::fluid {
namespace {

/// The part of the walls that a probe moves with.
std::size_t part_of(const ProbeMount& mount) {
  return mount.on == ProbeMount::On::obstacle ? static_cast<std::size_t>(mount.number) + 1 : 0;
}

}  // namespace

template <int dim>
Probes<dim>::Probes(const std::vector<Probe<dim>>& probes, const Mps<dim>& mps, const Interface& interface)
    : mps_(mps) {
  for (const Probe<dim>& probe : probes) add(probe, interface);
}

template <int dim>
void Probes<dim>::add(const Probe<dim>& probe, const Interface& interface) {
  switch (probe.quantity) {
    case Quantity::pressure:
      return add_pressure(probe, interface);
    case Quantity::level:
      return add_level(probe);
    case Quantity::force:
    case Quantity::moment:
      return add_load(probe, interface);
  }
}

template <int dim>
void Probes<dim>::add_value(const std::string& name, const std::string& unit,
                            std::function<double(const ProbeInput&)> read) {
  columns_.push_back({name, unit});
  readers_.push_back([read = std::move(read)](const ProbeInput& input, std::vector<double>& values) {
    values.push_back(read(input));
  });
}

template <int dim>
void Probes<dim>::add_pressure(const Probe<dim>& probe, const Interface& interface) {
  const Vector& x = probe.position;
  const ProbeMount& mount = probe.mount;
  if (mount.on == ProbeMount::On::body) {
    add_value(probe.name, "Pa",
              [at = SurfacePressureProbe<dim>(probe.name, x, interface, mps_.spacing())](
                  const ProbeInput& input) { return at.read(input.load.pressure); });
    return;
  }
  const Walls<dim>& walls = mps_.walls();
  const Vector on = mount.on == ProbeMount::On::obstacle ? walls.obstacle(mount.number).nearest(x) : x;
  add_value(probe.name, "Pa", [this, &walls, on, part = part_of(mount)](const ProbeInput& input) {
    return pressure_at(mps_, walls.motion(part).place(on, input.end));
  });
}

/// The line is fixed to the tank and goes up from its floor.
template <int dim>
void Probes<dim>::add_level(const Probe<dim>& probe) {
  const Motion<dim>& tank = mps_.walls().motion(0);
  const double floor = mps_.walls().tank().min[dim - 1];
  Vector foot = probe.position;
  foot[dim - 1] = floor;
  has_levels_ = true;
  add_value(probe.name, "m", [this, &tank, foot, floor](const ProbeInput& input) {
    const GaugeLine<dim> line{.foot = tank.place(foot, input.end),
                              .up = tank.turned(input.end) * Vector::Unit(dim - 1)};
    return floor + level_over(mps_, parts_, line, mps_.spacing());
  });
}

template <int dim>
void Probes<dim>::add_load(const Probe<dim>& probe, const Interface& interface) {
  const bool moment = probe.quantity == Quantity::moment;
  for (const std::string& name : probe.columns) columns_.push_back({name, moment ? "N m" : "N"});
  readers_.push_back(
      [load = load_on(probe, interface), moment](const ProbeInput& input, std::vector<double>& values) {
        const Load<dim> of = load(input);
        if (!moment)
          values.insert(values.end(), of.force.begin(), of.force.end());
        else if (dim == 3)
          values.insert(values.end(), of.moment.begin(), of.moment.end());
        else
          values.push_back(of.moment[2]);
      });
}

template <int dim>
auto Probes<dim>::load_on(const Probe<dim>& probe, const Interface& interface) -> ReadLoad {
  const ProbeMount& mount = probe.mount;
  const Vector& about = probe.position;
  if (mount.on == ProbeMount::On::body)
    return [load = BodyLoad<dim>(interface, mount.number, about, mps_.spacing())](const ProbeInput& input) {
      return load.read(input.motion, input.load);
    };
  has_wall_loads_ = true;
  return [this, load = WallLoad<dim>(mps_, mount, about)](const ProbeInput& input) {
    return load.read(mps_, place_, input.end);
  };
}

template <int dim>
std::vector<double> Probes<dim>::read(const ProbeInput& input) {
  if (has_levels_) parts_ = connected_water(mps_, mps_.spacing());
  if (has_wall_loads_) {
    place_.assign(static_cast<std::size_t>(mps_.initial_size()), -1);
    for (int i = 0; i < mps_.particles().size(); ++i) place_[mps_.particles().id[i]] = i;
  }
  std::vector<double> values;
  for (const auto& reader : readers_) reader(input, values);
  return values;
}

template class Probes<2>;
template class Probes<3>;

}  // namespace cosurge::fluid
