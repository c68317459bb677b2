#include "coupler/run_command.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"
#include "common/solvers.hpp"
#include "coupler/fault.hpp"
#include "coupler/interruption.hpp"
#include "coupler/progress/json_progress.hpp"
#include "coupler/recorded_run.hpp"
#include "coupler/result_folder.hpp"
#include "coupler/resumption.hpp"
#include "coupler/say.hpp"
#include "coupler/simulation.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr int exit_failed = 1;
constexpr int exit_interrupted = 130;

/// The text after "NAME=" in the option of this name; nothing if the option is "NAME" alone.
std::optional<std::string> of_name(const std::vector<std::string>& texts, const std::string& name) {
  for (const std::string& text : texts) {
    if (text == name) return "";
    if (text.starts_with(name + "=")) return text.substr(name.size() + 1);
  }
  return std::nullopt;
}

/// The user's program for a structure; empty: Cosurge's own.
std::string program_of(const RunOptions& options, const std::string& solid) {
  if (solid.empty()) return options.solid.empty() ? "" : options.solid.front();
  return of_name(options.solid, solid).value_or("");
}

/// Checks that the options name solvers of the case.
void require_names(const RunOptions& options, const v1::Case& the_case) {
  std::vector<std::string> solids = solid_names(the_case), names = solids;
  names.insert(names.begin(), "fluid");
  const auto named = [](const std::vector<std::string>& all, const std::string& text) {
    return std::find(all.begin(), all.end(), text.substr(0, text.find('='))) != all.end();
  };
  for (const std::string& text : options.by_hand)
    require(named(names, text), "--by-hand {}: must be one of {}, or NAME=tcp://ADDRESS:PORT", text,
            fmt::join(names, ", "));
  const auto over_tcp = [](const std::string& text) { return text.find("=tcp://") != std::string::npos; };
  require(options.allow.empty() || std::any_of(options.by_hand.begin(), options.by_hand.end(), over_tcp),
          "--allow is for a solver that somebody else starts at a tcp:// address: give --by-hand "
          "NAME=tcp://ADDRESS:PORT too");
  if (!has_several_solids(the_case)) {
    require(options.solid.size() <= 1,
            "--solid {}: the case has one structure, only one program can compute it",
            fmt::join(options.solid, " --solid "));
    return;
  }
  for (const std::string& text : options.solid)
    require(named(solids, text) && text.find('=') != std::string::npos,
            "--solid {}: the case has several structures: must be NAME=PROGRAM, NAME one of {}", text,
            fmt::join(solids, ", "));
}

/// Chooses the participant for the fluid or a structure, and starts it if it runs in another process.
/// `solid`: name of the structure, if the case has several.
void start(Simulation& simulation, const RunOptions& options, Role role, const std::string& solid,
           const fs::path& folder) {
  const bool fluid = role == Role::fluid;
  const std::string name = !solid.empty() ? solid : fluid ? "fluid" : "solid";
  const Reach reach{.patience = options.patience,
                    .threads = options.threads,
                    .log = folder / (name + "_solver.log"),
                    .allow = options.allow,
                    .solid = solid};
  if (options.in_process)
    return fluid ? simulation.in_thread(make_fluid_solver(), reach)
                 : simulation.in_thread(make_solid_solver(), reach);
  if (const auto endpoint = of_name(options.by_hand, name))
    return say("start the {} solver:\n  {}\n", name, simulation.by_hand(role, *endpoint, reach));
  simulation.in_process(role, fluid ? "" : program_of(options, solid), reach);
}

/// The standard output for lines of JSON, where the options ask for them.
std::unique_ptr<JsonLines> lines_of(const RunOptions& options) {
  return options.telling == Telling::json ? std::make_unique<JsonLines>() : nullptr;
}

/// The faults that the options ask for. @throws Error
std::vector<Fault> wanted_faults(const RunOptions& options, const v1::Case& the_case) {
  std::vector<std::string> solvers = solid_names(the_case), elsewhere;
  if (the_case.has_fluid()) solvers.insert(solvers.begin(), "fluid");
  for (const std::string& name : solvers)
    if (options.in_process || of_name(options.by_hand, name)) elsewhere.push_back(name);
  return faults_of(options.faults, solvers, the_case.time().end(), elsewhere);
}

int exit_of(const Outcome& outcome) {
  if (outcome.status == "finished") return 0;
  return outcome.status == "interrupted" ? exit_interrupted : exit_failed;
}

/// Starts the solvers and runs, from the beginning or from a checkpoint.
int launch(const RunOptions& options, const RecordedRun& job) {
  note_interruptions();
  try {
    std::optional<Simulation> simulation(std::in_place, job.the_case);
    simulation->give_up_when(interrupted, overdue);
    if (job.the_case.has_fluid()) start(*simulation, options, Role::fluid, "", job.folder);
    for (const std::string& solid : solid_names(job.the_case))
      start(*simulation, options, Role::solid, has_several_solids(job.the_case) ? solid : "", job.folder);
    const int exit_status = exit_of(run_recorded(*simulation, job));
    const bool left_behind = simulation->left_behind();
    simulation.reset();
    if (left_behind) std::_Exit(exit_status);  // returning would destroy objects that the thread still uses
    return exit_status;
  } catch (const std::exception&) {
    if (!interrupted()) throw;
    say("interrupted before the start of the run\n");
    return exit_interrupted;
  }
}

}  // namespace

int run_command(const RunOptions& options) {
  const std::unique_ptr<JsonLines> lines = lines_of(options);
  const v1::Case the_case = load_case(options.case_path, options.overrides);
  require_names(options, the_case);
  const std::vector<Fault> faults = wanted_faults(options, the_case);
  for (const std::string& doubt : doubts(the_case)) say("warning: {}\n", doubt);
  const ResultFolder folder(options.case_path, options.out);
  return launch(options, {.the_case = the_case,
                          .folder = folder.path(),
                          .provenance = Provenance::of_case(options.case_path, options.overrides),
                          .telling = options.telling,
                          .lines = lines.get(),
                          .faults = faults});
}

int resume_command(const RunOptions& options) {
  const std::unique_ptr<JsonLines> lines = lines_of(options);
  const ResultFolder folder = ResultFolder::of_a_run(options.out);
  const Resumption resumption = resumption_of(options.out, options.overrides);
  require_names(options, resumption.checkpoint.the_case);
  return launch(options, {.the_case = resumption.checkpoint.the_case,
                          .folder = folder.path(),
                          .provenance = resumption.provenance,
                          .resumption = &resumption,
                          .telling = options.telling,
                          .lines = lines.get()});
}

}  // namespace cosurge
