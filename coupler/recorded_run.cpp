#include "coupler/recorded_run.hpp"

#include "common/error.hpp"
#include "coupler/checkpoint.hpp"
#include "coupler/conclusion.hpp"
#include "coupler/coupler.hpp"
#include "coupler/progress/progress.hpp"
#include "coupler/recorder.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<Observer> make_progress(const RecordedRun& job, const Simulation& simulation) {
  const auto& members = simulation.members();
  if (job.telling == Telling::quiet) return std::make_unique<Notes>(stdout);
  if (job.telling == Telling::json)
    return std::make_unique<JsonProgress>(job.the_case, members, simulation.columns(), *job.lines);
  return std::make_unique<Progress>(job.the_case, members, simulation.columns(), stdout);
}

/// The new recorder of a run, with the data that the run had recorded when the checkpoint was written.
std::unique_ptr<Recorder> make_recorder(const RecordedRun& job, const Coupler& coupler) {
  const auto make = [&](const std::string& name) {
    return std::make_unique<Recorder>(job.folder, job.the_case, coupler.members(), coupler.interface(),
                                      coupler.columns(), job.provenance, name);
  };
  const fs::path results = job.folder / Recorder::results_name;
  if (job.resumption == nullptr) return make(results.filename());
  const fs::path fresh = results.string() + ".new";
  fs::remove(fresh);  // left by an interrupted resumption
  std::unique_ptr<Recorder> recorder;
  try {
    recorder = make(fresh.filename());
    replay(results, job.resumption->checkpoint, *recorder);
    recorder->flush();  // writes also the rows after the last frame: the old file is replaced next
    recorder->move(results);
  } catch (...) {
    recorder.reset();
    std::error_code none;
    fs::remove(fresh, none);  // frees its space on a full disk
    throw;
  }
  return recorder;
}

/// Computes all windows and returns the outcome.
Outcome compute(const RecordedRun& job, Simulation& simulation, Recorder& recorder,
                CheckpointWriter& checkpoints) {
  const auto by_signal = [&] {
    return fmt::format("by {} at t = {:.6g} s", interruption().value_or("the user"), simulation.time());
  };
  const auto progress = make_progress(job, simulation);
  for (Observer* observer : std::initializer_list<Observer*>{&recorder, &checkpoints, progress.get()})
    simulation.observe(*observer);
  const auto stop = [&, faults = job.faults]() mutable {
    let_fail(faults, simulation);
    return job.stop();
  };
  try {
    if (simulation.run(stop)) return {.status = "finished", .reason = ""};
    recorder.flush();
    checkpoints.write();
    return {.status = "interrupted", .reason = by_signal()};
  } catch (const Interrupted& interrupted) {
    return {.status = "interrupted",
            .reason = fmt::format("{}, within a window: {}; cosurge resume continues from the last frame",
                                  by_signal(), interrupted.what())};
  } catch (const std::exception& error) {
    return {.status = "failed",
            .reason = error.what(),
            .broken_down = dynamic_cast<const NumericalError*>(&error) != nullptr};
  }
}

/// Who computes, and where the results are.
void introduce(const RecordedRun& job, const Coupler& coupler) {
  if (job.telling == Telling::quiet) return;
  for (const Member& member : coupler.members())
    say("  {}: {} {}, {} particles\n", member.name, member.identity.program, member.identity.version,
        member.setup.particles);
  say("  results: {}\n", (job.folder / Recorder::results_name).string());
  if (job.resumption != nullptr) say("  resumed at t = {:.6g} s\n", job.resumption->checkpoint.time);
}

}  // namespace

Outcome run_recorded(Simulation& simulation, const RecordedRun& job) {
  const bool quiet = job.telling == Telling::quiet;
  if (!quiet) say("{}\n", job.the_case.title());
  simulation.begin();
  Coupler& coupler = simulation.coupler();
  if (job.resumption != nullptr) {
    job.resumption->checkpoint.require_same_programs(coupler.members());
    coupler.restore(job.resumption->checkpoint.state, job.resumption->same_scheme);
  }
  introduce(job, coupler);
  const auto recorder = make_recorder(job, coupler);
  CheckpointWriter checkpoints(job.folder, job.the_case, coupler);
  Outcome outcome = compute(job, simulation, *recorder, checkpoints);
  outcome.exchange_seconds = simulation.exchange_seconds();
  simulation.end(outcome.status == "finished" ? "the run is over" : outcome.reason, interrupted());
  conclude(job.folder, coupler, *recorder, checkpoints.time(), outcome, quiet);
  if (job.lines != nullptr)
    job.lines->end(outcome, coupler.time(), coupler.windows(), job.folder / Recorder::results_name);
  return outcome;
}

}  // namespace cosurge
