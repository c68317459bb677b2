// cosurge: launches the solvers of a case, couples them, records what they do.
#include <CLI/CLI.hpp>
#include <iostream>

#include "common/threads.hpp"
#include "common/version.hpp"
#include "coupler/check_command.hpp"
#include "coupler/run_command.hpp"

namespace {

void add_case(CLI::App& command, std::string& path, std::vector<std::string>& overrides) {
  command.add_option("case", path, "Folder with a case.toml, or the file")->required();
  command
      .add_option("--set", overrides,
                  "Values in place of the case's: key.path=value, entries of lists by number "
                  "(fluid.spacing=0.001 solid.model=rigid output.probe.0.name=top)")
      ->take_all();
}

}  // namespace

int main(int argc, char** argv) {
  cosurge::ensure_passive_waiting(argv);
  CLI::App app(
      "Cosurge computes what a wave impact does to an elastic structure, and what the structure does back to "
      "the water.",
      "cosurge");
  app.set_version_flag("--version", std::string("cosurge ") + cosurge::version);
  app.require_subcommand(1);

  cosurge::RunOptions run;
  CLI::App* run_app =
      app.add_subcommand("run", "Run a case: start its solvers, couple them, write the results");
  add_case(*run_app, run.case_path, run.overrides);
  run_app->add_option("--out", run.out,
                      "Folder of the results (default: results/NAME, numbered where it is taken)");
  CLI::Option* in_process = run_app->add_flag("--in-process", run.in_process,
                                              "Solvers as threads of this process, the same bit for bit");
  run_app
      ->add_option(
          "--by-hand", run.by_hand,
          "A solver that is not launched but awaited: fluid or solid, and where (solid=tcp://*:5555; "
          "default: a socket on this machine). The command to start it is shown")
      ->take_all()
      ->excludes(in_process);
  run_app->add_option("--threads", run.threads, "Threads of the fluid solver; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  run_app->add_option("--patience", run.patience, "Longest wait for a solver's answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();

  std::string check_path;
  std::vector<std::string> check_overrides;
  CLI::App* check_app = app.add_subcommand(
      "check", "Validate a case and show what would run: particles, windows, memory, time");
  add_case(*check_app, check_path, check_overrides);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    if (*run_app) return cosurge::run_command(run);
    cosurge::check_command(check_path, check_overrides);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
