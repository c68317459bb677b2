#include "python/python_solid.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "coupler/case_json.hpp"

namespace cosurge {
namespace {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A field as an array, a row a point, without a copy; read-only, and valid as long as the field is.
py::array view_of(const Field& field) {
  const auto row = static_cast<py::ssize_t>(sizeof(double)) * field.rows();
  const std::vector<py::ssize_t> shape = {field.cols(), field.rows()}, strides = {row, sizeof(double)};
  py::array_t<double> view(shape, strides, field.data(), py::capsule(field.data(), [](void*) {}));
  view.attr("flags").attr("writeable") = false;
  return view;
}

/// Takes over an array with a row a point. @throws Error where it has another shape, or no finite numbers.
void take(const py::handle& object, const std::string& what, Field& field) {
  const Array array = Array::ensure(object);
  require(bool(array), "{} is no array of numbers", what);
  require(array.ndim() == 2 && array.shape(0) == field.cols() && array.shape(1) == field.rows(),
          "{} has the shape {}, must be ({}, {}): a row for each point", what,
          py::str(array.attr("shape")).cast<std::string>(), field.cols(), field.rows());
  field = Eigen::Map<const Field>(array.data(), field.rows(), field.cols());
  require(field.allFinite(), "{} has values that are not finite", what);
}

}  // namespace

PythonSolid::PythonSolid(py::object solid, Thrown thrown)
    : name_(py::str(py::type::of(solid).attr("__name__")).cast<std::string>()),
      solid_(std::move(solid)),
      thrown_(std::move(thrown)) {}

PythonSolid::~PythonSolid() {
  const py::gil_scoped_acquire lock;
  solid_ = py::object();
}

/// Calls Python: what it throws becomes an Error, with the words that Python would print.
template <typename Action>
auto PythonSolid::call(const char* method, Action action) {
  const py::gil_scoped_acquire lock;
  try {
    return action();
  } catch (py::error_already_set& error) {
    *thrown_ = std::current_exception();
    throw Error(fmt::format("{}.{}(): {}", name_, method, error.what()));
  } catch (const py::cast_error& error) {
    throw Error(fmt::format("{}.{}(): {}", name_, method, error.what()));
  }
}

Identity PythonSolid::identity() const {
  return {.program = name_, .version = "python", .dimensions = {2, 3}, .capabilities = {"save", "frame"}};
}

Setup PythonSolid::initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad&,
                              InterfaceMotion& motion) {
  motion = InterfaceMotion::at_rest(interface.dimension, interface.points());
  position_ = interface.position;
  displacement_ = motion.displacement;
  return call("initialize", [&] {
    const py::object json = py::module_::import("json").attr("loads")(as_json(the_case));
    const Field position = interface.position, area = interface.area;
    solid_.attr("initialize")(json, view_of(position).attr("copy")(), view_of(area).attr("copy")(),
                              py::array(py::cast(interface.body)));
    Setup setup{.columns = {},
                .particles = static_cast<std::uint64_t>(interface.points()),
                .window = std::numeric_limits<double>::infinity()};
    for (const auto& [name, unit] :
         solid_.attr("columns").cast<std::vector<std::pair<std::string, std::string>>>())
      setup.columns.push_back({.name = name, .unit = unit});
    values_ = setup.columns.size();
    return setup;
  });
}

Report PythonSolid::advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) {
  if (window.attempt == Attempt::first) start_ = save();
  if (window.attempt == Attempt::again) restore(start_);
  return call("advance", [&] {
    const py::tuple answer = solid_.attr("advance")(window, view_of(load.force));
    require(answer.size() == 2 || answer.size() == 3,
            "{}.advance(): returned {} things, must be displacement, velocity and, if there are columns, "
            "their values",
            name_, answer.size());
    take(answer[0], name_ + ".advance(): the displacement", motion.displacement);
    take(answer[1], name_ + ".advance(): the velocity", motion.velocity);
    displacement_ = motion.displacement;
    Report report{.values = {}, .window = std::numeric_limits<double>::infinity()};
    if (answer.size() == 3) report.values = answer[2].cast<std::vector<double>>();
    require(report.values.size() == values_, "{}.advance(): returned {} values for {} columns", name_,
            report.values.size(), values_);
    return report;
  });
}

std::string PythonSolid::save() {
  return call("save", [&] { return std::string(solid_.attr("save")().cast<py::bytes>()); });
}

void PythonSolid::restore(const std::string& state) {
  call("restore", [&] { solid_.attr("restore")(py::bytes(state)); });
}

Snapshot PythonSolid::frame() {
  const Field place = position_ + displacement_;
  std::vector<float> values(place.data(), place.data() + place.size());
  return {{.name = "position", .unit = "m", .components = static_cast<int>(place.rows()), .values = values}};
}

}  // namespace cosurge
