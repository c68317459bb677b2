#include "python/python_run.hpp"

#include <pybind11/stl.h>

#include <optional>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/threads.hpp"
#include "coupler/case_json.hpp"
#include "coupler/recorded_run.hpp"
#include "coupler/recorder.hpp"
#include "coupler/result_folder.hpp"
#include "python/python_solid.hpp"

namespace cosurge {
namespace {

namespace py = pybind11;

v1::Case case_of(const CaseSource& source) {
  return source.path.empty() ? read_case(source.text, source.set, source.folder)
                             : load_case(source.path, source.set);
}

/// Calls a function of Python after every window, and looks for an interruption from the keyboard.
class Watcher : public Observer {
 public:
  Watcher(const py::object& callback, Thrown thrown) : callback_(callback), thrown_(std::move(thrown)) {}

  void know(const Simulation& simulation) {
    for (const Member& member : simulation.members())
      for (const Column& column : member.setup.columns) names_.push_back(member.name + "/" + column.name);
    for (const Column& column : simulation.columns()) names_.push_back("coupling/" + column.name);
  }

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override {
    const py::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (callback_.is_none()) return;
      std::vector<double> values;
      for (const Report& report : reports)
        values.insert(values.end(), report.values.begin(), report.values.end());
      values.insert(values.end(), coupling.begin(), coupling.end());
      py::dict named;
      for (std::size_t k = 0; k < values.size(); ++k) named[py::str(names_[k])] = values[k];
      const py::object answer = callback_(window.start + window.size, named);
      if (answer.is(py::bool_(true))) stop_ = true;
    } catch (...) {
      *thrown_ = std::current_exception();
      stop_ = true;
    }
  }

  bool stopped() const { return stop_; }

 private:
  const py::object& callback_;
  Thrown thrown_;
  std::vector<std::string> names_;
  bool stop_ = false;
};

/// Chooses who computes the fluid and the structure.
void choose(Simulation& simulation, const PythonRun& run, const std::filesystem::path& folder,
            const Thrown& thrown) {
  const bool object = !run.solid.is_none() && !py::isinstance<py::str>(run.solid);
  const auto reach = [&](const char* name) {
    return Reach{.patience = 600,
                 .threads = run.threads,
                 .log = folder / (std::string(name) + "_solver.log"),
                 .solid = ""};
  };
  require(run.solid.is_none() || object || run.wire, "a program as the solid needs wire=True");
  const v1::Case& the_case = simulation.the_case();
  if (run.wire && the_case.has_fluid()) simulation.in_process(Role::fluid, "", reach("fluid"));
  if (object && run.wire)
    return simulation.in_thread(std::make_unique<PythonSolid>(run.solid, thrown), reach("solid"));
  if (object) return simulation.here(std::make_unique<PythonSolid>(run.solid, thrown));
  if (run.wire && the_case.has_solid())
    simulation.in_process(Role::solid, run.solid.is_none() ? "" : run.solid.cast<std::string>(),
                          reach("solid"));
}

/// The run without the interpreter's lock, which callbacks take for themselves.
Outcome run_unlocked(std::optional<Simulation>& simulation, const RecordedRun& job, Watcher& watcher) {
  const py::gil_scoped_release unlocked;
  simulation->begin();
  watcher.know(*simulation);
  simulation->observe(watcher);
  Outcome outcome = run_recorded(*simulation, job);
  simulation.reset();
  return outcome;
}

}  // namespace

std::string checked_case(const CaseSource& source) { return as_json(case_of(source)); }

std::string run_from_python(const PythonRun& run) {
  const v1::Case the_case = case_of(run.source);
  const ResultFolder folder(run.source.path.empty() ? "case" : run.source.path, run.out);
  const auto thrown = std::make_shared<std::exception_ptr>();
  Watcher watcher(run.on_window, thrown);
  std::optional<Simulation> simulation(std::in_place, the_case);
  Outcome outcome;
  try {
    choose(*simulation, run, folder.path(), thrown);
    set_threads(run.threads);
    outcome = run_unlocked(
        simulation,
        {.the_case = the_case,
         .folder = folder.path(),
         .provenance = run.source.path.empty()
                           ? Provenance{.case_file = "", .overrides = run.source.set, .changes = {}}
                           : Provenance::of_case(run.source.path, run.source.set),
         .telling = Telling::quiet,
         .stop = [&watcher] { return watcher.stopped(); }},
        watcher);
  } catch (...) {
    {
      const py::gil_scoped_release unlocked;
      simulation.reset();
    }
    if (*thrown) std::rethrow_exception(*thrown);
    throw;
  }
  if (*thrown) std::rethrow_exception(*thrown);
  if (outcome.status == "failed" && outcome.broken_down) throw NumericalError(outcome.reason);
  require(outcome.status != "failed", "{}", outcome.reason);
  return folder.path().string();
}

}  // namespace cosurge
