#include "coupler/run_command.hpp"

#include <filesystem>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>

#include "common/case_doubts.hpp"
#include "common/case_file.hpp"
#include "common/error.hpp"
#include "common/solvers.hpp"
#include "coupler/checkpoint.hpp"
#include "coupler/conclusion.hpp"
#include "coupler/interruption.hpp"
#include "coupler/launcher.hpp"
#include "coupler/progress.hpp"
#include "coupler/recorder.hpp"
#include "coupler/result_folder.hpp"
#include "coupler/resumption.hpp"
#include "coupler/run_folder.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr int exit_failed = 1;
constexpr int exit_interrupted = 130;
constexpr std::chrono::milliseconds grace{2000};                 // for solvers to end by themselves
constexpr std::chrono::milliseconds grace_of_interruption{200};  // the same, for a user who waits

/// The endpoint where a solver that is started by hand is awaited; nothing where it is not.
std::optional<std::string> by_hand(const RunOptions& options, const std::string& role) {
  for (const std::string& text : options.by_hand) {
    if (text == role) return "";
    if (text.starts_with(role + "=")) return text.substr(role.size() + 1);
  }
  return std::nullopt;
}

Solver start(const RunOptions& options, Role role, const fs::path& sockets, const fs::path& folder) {
  const bool fluid = role == Role::fluid;
  const std::string name = fluid ? "fluid" : "solid";
  const std::string program = name + "_solver";
  const int cores =
      options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  const int threads = fluid ? cores : 1;  // the solid's loops are too short to share
  if (options.in_process)
    return Solver::thread(fluid ? make_fluid_solver() : make_solid_solver(), options.patience, threads);
  const auto endpoint = by_hand(options, name);
  const Wiring wiring{.folder = sockets, .listen = endpoint.value_or(""), .patience = options.patience};
  if (endpoint) {
    Solver solver = Solver::by_hand(role, wiring, program);
    say("start the {} solver:\n  {}\n", name, solver.how_to_start());
    return solver;
  }
  Command command{
      .program = beside_this_program(program), .arguments = {}, .log = folder / (program + ".log")};
  if (!fluid && !options.solid.empty()) {
    std::istringstream words(options.solid);
    words >> command.program;
    command.arguments.assign(std::istream_iterator<std::string>(words), {});
  }
  return Solver::process(role, wiring, command, threads);
}

/// The solvers of a case, started together and then welcomed.
class Solvers {
 public:
  Solvers(const RunOptions& options, const v1::Case& the_case, const fs::path& folder) {
    if (the_case.has_fluid()) fluid_.emplace(start(options, Role::fluid, sockets_.path(), folder));
    if (the_case.has_solid()) solid_.emplace(start(options, Role::solid, sockets_.path(), folder));
    for (auto* solver : {&fluid_, &solid_})
      if (*solver) (*solver)->join(the_case.dimension(), {"save", "frame"}, [this] { return cancelled(); });
    joined_ = true;
  }

  Participants participants() {
    return {.fluid = fluid_ ? &fluid_->participant() : nullptr,
            .solid = solid_ ? &solid_->participant() : nullptr};
  }

  /// Time of the messages in addition to the solvers' computing time [s].
  double exchange_seconds() const {
    double sum = 0;
    for (const auto* solver : {&fluid_, &solid_})
      if (*solver) sum += (*solver)->participant().cost().exchange();
    return sum;
  }

  /// Ends those that have not ended; all hear of it before any is waited for.
  void stop(const std::string& reason) {
    for (auto* solver : {&fluid_, &solid_})
      if (*solver) (*solver)->tell(reason);
    for (auto* solver : {&fluid_, &solid_}) {
      if (!*solver) continue;
      if (interrupted())
        left_behind_ |= !(*solver)->kill(reason, grace_of_interruption);
      else
        (*solver)->stop(reason, grace);
    }
  }

  /// Whether a solver still computes in a thread of this process.
  bool left_behind() const { return left_behind_; }

 private:
  /// Asked while a solver is waited for.
  bool cancelled() {
    if (joined_) return overdue();
    for (auto* solver : {&fluid_, &solid_})
      if (*solver) (*solver)->turn_away_strangers();
    return interrupted();
  }

  RunFolder sockets_;
  std::optional<Solver> fluid_;
  std::optional<Solver> solid_;
  bool joined_ = false;
  bool left_behind_ = false;
};

/// A new case, or a resumption.
struct Job {
  v1::Case the_case;
  fs::path folder;  // folder of the results
  Provenance provenance;
  const Resumption* resumption = nullptr;
};

/// The new recorder of a run, with the data that the run had recorded when the checkpoint was written.
std::unique_ptr<Recorder> make_recorder(const Job& job, const Coupler& coupler) {
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
    recorder->flush();  // also the rows after the last frame: from here on the old file is gone
    recorder->move(results);
  } catch (...) {
    recorder.reset();
    std::error_code none;
    fs::remove(fresh, none);  // a full disk needs the room
    throw;
  }
  return recorder;
}

/// All windows, and how it went.
Outcome compute(const v1::Case& the_case, Coupler& coupler, Recorder& recorder,
                CheckpointWriter& checkpoints) {
  const auto by_signal = [&] {
    return fmt::format("by {} at t = {:.6g} s", interruption().value_or("a signal"), coupler.time());
  };
  try {
    Progress progress(the_case, coupler.members(), coupler.columns(), stdout);
    if (coupler.run({&recorder, &checkpoints, &progress}, interrupted))
      return {.status = "finished", .reason = ""};
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

/// The run once the solvers are there. Returns the exit status.
int run_with(Solvers& solvers, const Job& job) {
  const auto& [the_case, folder, provenance, resumption] = job;
  say("{}\n", the_case.title());
  Coupler coupler(the_case, solvers.participants());
  if (resumption != nullptr) {
    resumption->checkpoint.require_same_programs(coupler.members());
    coupler.restore(resumption->checkpoint.state, resumption->same_scheme);
  }
  for (const Member& member : coupler.members())
    say("  {}: {} {}, {} particles\n", member.name, member.identity.program, member.identity.version,
        member.setup.particles);
  say("  results: {}\n", (folder / Recorder::results_name).string());
  if (resumption != nullptr) say("  resumed at t = {:.6g} s\n", resumption->checkpoint.time);

  const auto recorder = make_recorder(job, coupler);
  CheckpointWriter checkpoints(folder, the_case, coupler);
  Outcome outcome = compute(the_case, coupler, *recorder, checkpoints);
  outcome.exchange_seconds = solvers.exchange_seconds();
  solvers.stop(outcome.status == "finished" ? "the run is over" : outcome.reason);
  conclude(folder, coupler, *recorder, checkpoints.time(), outcome);
  if (outcome.status == "finished") return 0;
  return outcome.status == "interrupted" ? exit_interrupted : exit_failed;
}

/// Starts the solvers and runs, from the beginning or from a checkpoint.
int launch(const RunOptions& options, const Job& job) {
  note_interruptions();
  try {
    std::optional<Solvers> solvers(std::in_place, options, job.the_case, job.folder);
    const int exit_status = run_with(*solvers, job);
    const bool left_behind = solvers->left_behind();
    solvers.reset();
    if (left_behind) std::_Exit(exit_status);  // a return would destroy objects that the thread still uses
    return exit_status;
  } catch (const std::exception&) {
    if (!interrupted()) throw;
    say("interrupted before the start of the run\n");
    return exit_interrupted;
  }
}

}  // namespace

int run_command(const RunOptions& options) {
  const v1::Case the_case = load_case(options.case_path, options.overrides);
  for (const std::string& doubt : doubts(the_case)) say("warning: {}\n", doubt);
  const ResultFolder folder(options.case_path, options.out);
  return launch(options, {.the_case = the_case,
                          .folder = folder.path(),
                          .provenance = Provenance::of_case(options.case_path, options.overrides)});
}

int resume_command(const RunOptions& options) {
  const ResultFolder folder = ResultFolder::of_a_run(options.out);
  const Resumption resumption = resumption_of(options.out, options.overrides);
  return launch(options, {.the_case = resumption.checkpoint.the_case,
                          .folder = folder.path(),
                          .provenance = resumption.provenance,
                          .resumption = &resumption});
}

}  // namespace cosurge
