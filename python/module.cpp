// The compiled part of the module cosurge; python/cosurge says what its functions do.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "common/faults.hpp"
#include "common/version.hpp"
#include "common/wire/serve_main.hpp"
#include "coupler/report/report_command.hpp"
#include "python/python_run.hpp"
#include "python/python_solid.hpp"

namespace py = pybind11;

namespace {

/// A solver program around an object of Python: returns the exit code.
int serve(const py::object& solid, std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto thrown = std::make_shared<std::exception_ptr>();
  std::unique_ptr<cosurge::Participant> participant = std::make_unique<cosurge::PythonSolid>(solid, thrown);
  const py::gil_scoped_release unlocked;
  return cosurge::serve_main(static_cast<int>(words.size()), arguments.data(),
                             [&] { return std::move(participant); });
}

}  // namespace

PYBIND11_MODULE(_cosurge, module) {
  module.attr("version") = std::string(cosurge::version);
  py::register_exception<cosurge::Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<cosurge::NumericalError>(module, "NumericalError", PyExc_ArithmeticError);

  py::class_<cosurge::Window>(module, "Window", "A coupling window from start to start + size [s].")
      .def_readonly("index", &cosurge::Window::index)
      .def_readonly("start", &cosurge::Window::start)
      .def_readonly("size", &cosurge::Window::size);

  module.def("checked_case", [](const std::string& path, const std::string& text, const std::string& folder,
                                const std::vector<std::string>& set) {
    return cosurge::checked_case({.path = path, .text = text, .folder = folder, .set = set});
  });
  module.def("run", [](const std::string& path, const std::string& text, const std::string& folder,
                       const std::vector<std::string>& set, const std::string& out, const py::object& solid,
                       const py::object& on_window, bool wire, int threads) {
    return cosurge::run_from_python({.source = {.path = path, .text = text, .folder = folder, .set = set},
                                     .out = out,
                                     .solid = solid,
                                     .on_window = on_window,
                                     .wire = wire,
                                     .threads = threads});
  });
  module.def("report_page", [](const std::vector<std::string>& results, double megabytes) {
    cosurge::ReportOptions options;
    options.results = results;
    options.megabytes = megabytes;
    return cosurge::report_page(options);
  });
  module.def("serve", &serve);
}
