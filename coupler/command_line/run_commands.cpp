// Commands that run a case or test a solver.
#include <memory>

#include "coupler/certify_command.hpp"
#include "coupler/command_line/command.hpp"
#include "coupler/keys_command.hpp"
#include "coupler/run_command.hpp"
#include "coupler/say.hpp"
#include "coupler/selftest_command.hpp"
#include "coupler/status_command.hpp"

namespace cosurge {
namespace {

/// How the solvers are started, which does not change the answer.
void add_solvers(CLI::App& command, RunOptions& options) {
  CLI::Option* in_process =
      command.add_flag("--in-process", options.in_process,
                       "Run the solvers as threads of this process; the results are bit-identical");
  command
      .add_option(
          "--by-hand", options.by_hand,
          "Wait for a solver instead of starting it: fluid, solid or the name of one of several structures, "
          "and "
          "the address (solid=tcp://*:5555; default: a socket on this machine). The command to start it is "
          "printed")
      ->take_all()
      ->excludes(in_process);
  command
      .add_option("--allow", options.allow,
                  "File with the machines that may connect to a tcp:// address, a line NAME KEY each, as "
                  "cosurge keys prints it; needed unless the address is 127.0.0.1")
      ->excludes(in_process);
  command
      .add_option("--solid", options.solid,
                  "Your own program instead of solid_solver, with its arguments in one text; it gets "
                  "--connect and --threads (docs/write_your_own_solid.md); NAME=PROGRAM for one of several "
                  "structures")
      ->take_all()
      ->excludes(in_process);
  command.add_option("--threads", options.threads, "Threads of the fluid solver; 0: one per core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--patience", options.patience, "Longest wait for a solver's answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// What a run says while it goes.
void add_telling(CLI::App& command, RunOptions& options) {
  CLI::Option* quiet = command.add_flag_callback(
      "--quiet", [&options] { options.telling = Telling::quiet; },
      "Say nothing but warnings, and the end of a run that did not finish");
  command
      .add_flag_callback(
          "--json-progress", [&options] { options.telling = Telling::json; },
          "For scripts: write the progress to the standard output, a JSON object a line "
          "(docs/results.md); words go to the standard error")
      ->excludes(quiet);
}

}  // namespace

Command add_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      app.add_subcommand("run", "Run a case: start its solvers, couple them, write the results");
  add_case(*command, options->case_path, options->overrides);
  command->add_option("--out", options->out,
                      "Folder of the results (default: results/NAME, with a number if it exists)");
  add_solvers(*command, *options);
  command
      ->add_option(
          "--fault", options->faults,
          "Let a solver fail: KIND:SOLVER@TIME, for instance kill:solid@0.05 with the time in s; kill or "
          "freeze its process, delay its answer by 5 s, or corrupt its answer")
      ->take_all();
  add_telling(*command, *options);
  return {command, [options] { return run_command(*options); }};
}

Command add_resume(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("resume",
                                         "Continue a run that was interrupted, failed or was killed, from "
                                         "its last frame; or extend a finished run");
  command->add_option("folder", options->out, "Folder of its results")->required();
  command
      ->add_option("--set", options->overrides,
                   "Override values of time, coupling, output.frame_interval, fluid.courant, fluid.pressure "
                   "and fluid.most_lost (time.end=2 coupling.scheme=strong)")
      ->take_all();
  add_solvers(*command, *options);
  add_telling(*command, *options);
  return {command, [options] { return resume_command(*options); }};
}

Command add_status(CLI::App& app) {
  const auto folder = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("status", "Show the progress and speed of a run, and how to resume it");
  command->add_option("folder", *folder, "Folder of its results")->required();
  return {command, [folder] {
            say("{}", status_of(*folder));
            return 0;
          }};
}

Command add_keys(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "keys", "Show the public key of this machine, for runs across machines; make its keys if it has none");
  return {command, [] {
            say("{}", keys_command());
            return 0;
          }};
}

Command add_selftest(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "selftest",
      "Compare the coupling with theory: frequency and stability limit of water on a sprung piston");
  return {command, selftest_command};
}

Command add_certify(CLI::App& app) {
  const auto options = std::make_shared<CertifyOptions>();
  const auto role = std::make_shared<std::string>("solid");
  CLI::App* command = app.add_subcommand(
      "certify", "Check protocol conformance of a solver program: cosurge certify -- PROGRAM ARGUMENTS");
  command->add_option("command", options->command, "The program and its arguments, after --")->required();
  command->add_option("--set", options->overrides, "Override values of the test scene (solid.model=fem)");
  command->add_option("--role", *role, "What it solves")
      ->check(CLI::IsMember({"fluid", "solid"}))
      ->capture_default_str();
  command->add_option("--patience", options->patience, "Longest wait for an answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  return {command, [options, role] {
            options->role = *role == "fluid" ? Role::fluid : Role::solid;
            return certify_command(*options);
          }};
}

}  // namespace cosurge
