#include "common/wire/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "common/error.hpp"
#include "common/wire/wire_words.hpp"

namespace cosurge {
namespace {

using Numbers = google::protobuf::RepeatedField<double>;

constexpr std::size_t most_of_a_program = 100;  // [bytes] of its name
constexpr int most_modes = 1000, most_columns = 10000, most_arrays = 100, most_notes = 100;
constexpr std::size_t most_of_a_note = 1000;  // [bytes]

template <typename Matrix>
void encode(const Matrix& values, Numbers& numbers) {
  numbers.Resize(static_cast<int>(values.size()), 0.0);
  std::copy_n(values.data(), values.size(), numbers.mutable_data());
}

/// The matrix must have the size that is expected of the message.
template <typename Matrix>
void decode(const Numbers& numbers, const char* name, Matrix& values) {
  require(numbers.size() == values.size(), "{} has {} numbers instead of {} x {}", name, numbers.size(),
          values.rows(), values.cols());
  std::copy_n(numbers.data(), numbers.size(), values.data());
  if (values.allFinite()) return;
  const auto wrong = std::find_if_not(values.data(), values.data() + values.size(),
                                      [](double x) { return std::isfinite(x); });
  constexpr bool scalars = Matrix::ColsAtCompileTime == 1;
  const Eigen::Index per_point = scalars ? 1 : values.rows();
  throw Error(fmt::format("{} of point {} is {}", name, (wrong - values.data()) / per_point, *wrong));
}

/// Not merely equal to zero: a negative zero must arrive as one.
bool all_bits_zero(const Field& field) {
  return std::all_of(field.data(), field.data() + field.size(),
                     [](double x) { return std::bit_cast<std::uint64_t>(x) == 0; });
}

/// The largest window that a solver allows may be infinite.
double checked_window(double window) {
  require(window > 0, "the largest window is {} s, must be > 0", window);
  return window;
}

}  // namespace

void encode(Role role, const Identity& identity, v1::Hello& message) {
  message.set_role(role == Role::fluid ? v1::FLUID : v1::SOLID);
  message.set_program(identity.program);
  message.set_version(identity.version);
  for (const int dimension : identity.dimensions)
    message.add_dimensions(static_cast<std::uint32_t>(dimension));
  for (const std::string& capability : identity.capabilities) message.add_capabilities(capability);
}

Role role_of(const v1::Hello& message) {
  require(message.role() == v1::FLUID || message.role() == v1::SOLID, "role {} is neither fluid nor solid",
          static_cast<int>(message.role()));
  return message.role() == v1::FLUID ? Role::fluid : Role::solid;
}

Identity decode(const v1::Hello& message) {
  return {.program = printable(message.program(), most_of_a_program),
          .version = printable(message.version(), most_of_a_program),
          .dimensions = {message.dimensions().begin(), message.dimensions().end()},
          .capabilities = {message.capabilities().begin(), message.capabilities().end()}};
}

void encode(const Interface& interface, v1::Interface& message) {
  message.set_dimension(static_cast<std::uint32_t>(interface.dimension));
  encode(interface.position, *message.mutable_position());
  encode(interface.area, *message.mutable_area());
  message.mutable_body()->Assign(interface.body.begin(), interface.body.end());
}

Interface decode(const v1::Interface& message, int dimension, int bodies) {
  require(static_cast<int>(message.dimension()) == dimension, "the interface has {} dimensions, the case {}",
          message.dimension(), dimension);
  Interface interface {
    .dimension = dimension, .position = Field(dimension, message.body_size()),
    .area = Field(dimension, message.body_size()), .body = {
      message.body().begin(),
      message.body().end()
    }
  };
  decode(message.position(), "position", interface.position);
  decode(message.area(), "area", interface.area);
  for (const int body : interface.body) {
    require(body >= 0 && body < bodies, "a point of the interface lies on body {} of {}", body, bodies);
  }
  return interface;
}

void encode(const InterfaceMotion& motion, v1::Motion& message) {
  encode(motion.displacement, *message.mutable_displacement());
  encode(motion.velocity, *message.mutable_velocity());
  message.clear_ramp_increment();
  if (!all_bits_zero(motion.ramp_increment)) encode(motion.ramp_increment, *message.mutable_ramp_increment());
  message.set_frequency(motion.frequency);
  message.clear_modes();
  for (const Mode& mode : motion.modes) {
    v1::Mode& sent = *message.add_modes();
    encode(mode.shape, *sent.mutable_shape());
    sent.set_mobility(mode.mobility);
    sent.set_load(mode.load);
  }
}

void decode(const v1::Motion& message, InterfaceMotion& motion) {
  decode(message.displacement(), "displacement", motion.displacement);
  decode(message.velocity(), "velocity", motion.velocity);
  if (message.ramp_increment().empty()) {
    motion.ramp_increment.setZero();
  } else {
    decode(message.ramp_increment(), "ramp_increment", motion.ramp_increment);
  }
  require(std::isfinite(message.frequency()) && message.frequency() >= 0,
          "frequency is {} rad/s, must be finite and >= 0", message.frequency());
  motion.frequency = message.frequency();
  motion.modes.clear();
  require(message.modes_size() <= most_modes, "{} modes, must be <= {}", message.modes_size(), most_modes);
  for (const v1::Mode& sent : message.modes()) {
    Mode mode{.shape = Field(motion.velocity.rows(), motion.velocity.cols()),
              .mobility = sent.mobility(),
              .load = sent.load()};
    decode(sent.shape(), "shape of a mode", mode.shape);
    require(std::isfinite(mode.load) && std::isfinite(mode.mobility) && mode.mobility >= 0,
            "a mode has a mobility of {} and a load of {}", mode.mobility, mode.load);
    motion.modes.push_back(std::move(mode));
  }
}

void encode(const InterfaceLoad& load, v1::Load& message) {
  encode(load.force, *message.mutable_force());
  encode(load.pressure, *message.mutable_pressure());
}

void decode(const v1::Load& message, InterfaceLoad& load) {
  decode(message.force(), "force", load.force);
  decode(message.pressure(), "pressure", load.pressure);
}

void encode(const Window& window, v1::Window& message) {
  message.set_index(window.index);
  message.set_start(window.start);
  message.set_size(window.size);
  message.set_attempt(static_cast<std::uint32_t>(window.attempt));
}

Window decode(const v1::Window& message) {
  require(std::isfinite(message.start()), "window {} starts at {} s", message.index(), message.start());
  require(std::isfinite(message.size()) && message.size() > 0, "window {} is {} s long, must be > 0",
          message.index(), message.size());
  return {.index = message.index(),
          .start = message.start(),
          .size = message.size(),
          .attempt = message.attempt() < 2 ? static_cast<Attempt>(message.attempt()) : Attempt::again};
}

void encode(const Setup& setup, v1::Initialized& message) {
  for (const Column& column : setup.columns) {
    v1::Column& sent = *message.add_columns();
    sent.set_name(column.name);
    sent.set_unit(column.unit);
  }
  message.set_particles(setup.particles);
  message.set_window(setup.window);
  message.set_substep(setup.substep);
}

Setup decode(const v1::Initialized& message) {
  Setup setup{.columns = {},
              .particles = message.particles(),
              .window = checked_window(message.window()),
              .substep = message.substep()};
  require(std::isfinite(setup.substep) && setup.substep >= 0, "the sub-step is {} s, must be >= 0",
          setup.substep);
  require(message.columns_size() <= most_columns, "{} columns, must be <= {}", message.columns_size(),
          most_columns);
  for (const v1::Column& column : message.columns()) require_name(column.name(), "a column");
  for (const v1::Column& column : message.columns()) setup.columns.push_back({column.name(), column.unit()});
  return setup;
}

void encode(const Report& report, v1::Advanced& message) {
  message.mutable_values()->Assign(report.values.begin(), report.values.end());
  message.set_window(report.window);
  for (const std::string& note : report.notes) message.add_notes(note);
}

Report decode(const v1::Advanced& message, std::size_t columns) {
  require(static_cast<std::size_t>(message.values_size()) == columns, "{} values reported instead of {}",
          message.values_size(), columns);
  for (int k = 0; k < message.values_size(); ++k) {
    require(std::isfinite(message.values(k)), "reported value {} is {}", k, message.values(k));
  }
  require(message.notes_size() <= most_notes, "{} notes on one window, must be <= {}", message.notes_size(),
          most_notes);
  std::vector<std::string> notes;
  for (const std::string& note : message.notes()) notes.push_back(printable(note, most_of_a_note));
  return {.values = {message.values().begin(), message.values().end()},
          .window = checked_window(message.window()),
          .notes = std::move(notes)};
}

void require_few_arrays(int count) {
  require(count <= most_arrays, "{} arrays in a frame, must be <= {}", count, most_arrays);
}

Snapshot decode(const v1::Snapshot& message) {
  constexpr std::uint32_t most_components = 9;  // a tensor
  Snapshot snapshot;
  require_few_arrays(message.arrays_size());
  for (const v1::Array& array : message.arrays()) {
    require_name(array.name(), "an array");
    const std::uint32_t components = array.components();
    require(components >= 1 && components <= most_components &&
                array.values_size() % static_cast<int>(components) == 0,
            "array {} of a frame has {} numbers of {} components", array.name(), array.values_size(),
            components);
    const auto wrong = std::find_if_not(array.values().begin(), array.values().end(),
                                        [](float x) { return std::isfinite(x); });
    require(wrong == array.values().end(), "{} of particle {} is not finite", array.name(),
            (wrong - array.values().begin()) / static_cast<int>(components));
    snapshot.push_back({.name = array.name(),
                        .unit = array.unit(),
                        .components = static_cast<int>(components),
                        .values = {array.values().begin(), array.values().end()}});
  }
  return snapshot;
}

}  // namespace cosurge
