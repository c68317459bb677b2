// cosurge: launches the solvers of a case, couples them, records what they do.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "common/threads.hpp"
#include "common/version.hpp"
#include "common/wire_words.hpp"
#include "coupler/certify_command.hpp"
#include "coupler/check_command.hpp"
#include "coupler/csv_command.hpp"
#include "coupler/map_command.hpp"
#include "coupler/report/report_command.hpp"
#include "coupler/report/watch_command.hpp"
#include "coupler/run_command.hpp"
#include "coupler/say.hpp"
#include "coupler/selftest_command.hpp"
#include "coupler/status_command.hpp"

namespace {

void add_case(CLI::App& command, std::string& path, std::vector<std::string>& overrides) {
  command.add_option("case", path, "Folder with a case.toml, or the file")->required();
  command
      .add_option("--set", overrides,
                  "Values in place of the case's: key.path=value, entries of lists by number "
                  "(fluid.spacing=0.001 solid.model=rigid output.probe.0.name=top)")
      ->take_all();
}

/// How the solvers are started, which does not change the answer.
void add_solvers(CLI::App& command, cosurge::RunOptions& options) {
  CLI::Option* in_process = command.add_flag("--in-process", options.in_process,
                                             "Solvers as threads of this process, the same bit for bit");
  command
      .add_option("--by-hand", options.by_hand,
                  "A solver that is not launched but awaited: fluid or solid, and where (solid=tcp://*:5555; "
                  "default: a socket on this machine). The command to start it is shown")
      ->take_all()
      ->excludes(in_process);
  command
      .add_option(
          "--solid", options.solid,
          "A program of your own in place of solid_solver, with its arguments in one text; it is told "
          "--connect and --threads (docs/write_your_own_solid.md)")
      ->excludes(in_process);
  command.add_option("--threads", options.threads, "Threads of the fluid solver; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--patience", options.patience, "Longest wait for a solver's answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

CLI::App* add_report(CLI::App& app, cosurge::ReportOptions& report) {
  CLI::App* command = app.add_subcommand(
      "report", "Write one page for a browser: the scene plays, with histories and tables");
  command->add_option("results", report.results, "Folders of results; several lie on top of each other")
      ->required();
  command->add_option("--out", report.out, "The page (default: report.html in the first folder)");
  command->add_option("--case", report.case_folder,
                      "Folder with reference/*.csv (default: that of the case, which the results name)");
  command
      ->add_option("--size", report.megabytes,
                   "Size of the page, about [MB]: it shows fewer frames or particles")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
  return command;
}

CLI::App* add_watch(CLI::App& app, cosurge::WatchOptions& watch) {
  CLI::App* command = app.add_subcommand(
      "watch", "Show a run in a browser of this machine while it goes on, with the time left");
  command->add_option("results", watch.results, "Folders of results; several lie on top of each other")
      ->required();
  command->add_option("--port", watch.port, "Port on 127.0.0.1 (default: any that is free)")
      ->check(CLI::Range(1, 65535));
  command
      ->add_option("--size", watch.megabytes,
                   "Size of the page, about [MB]: it shows fewer frames or particles")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
  return command;
}

/// Letters to insert, leave out, change or swap with the next to make one word of the other (Damerau 1964).
std::size_t difference(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// The message for a word that is not a command; empty if it is one.
std::string unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return difference(word, a) < difference(word, b);
  });
  const bool near = difference(word, *nearest) <= std::max<std::size_t>(1, nearest->size() / 3);
  return fmt::format("cosurge {}: no such command{}. There are {}; cosurge COMMAND --help explains one", word,
                     near ? fmt::format(", did you mean cosurge {}?", *nearest) : "", fmt::join(names, ", "));
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
  add_solvers(*run_app, run);

  cosurge::RunOptions resume;
  CLI::App* resume_app = app.add_subcommand(
      "resume",
      "Go on with a run that was interrupted, failed or was killed, from its last frame, or beyond its end");
  resume_app->add_option("folder", resume.out, "Folder of its results")->required();
  resume_app
      ->add_option("--set", resume.overrides,
                   "Values in place of the case's, of time, coupling, output.frame_interval, fluid.courant, "
                   "fluid.pressure and fluid.most_lost (time.end=2 coupling.scheme=strong)")
      ->take_all();
  add_solvers(*resume_app, resume);

  std::string check_path;
  std::vector<std::string> check_overrides;
  CLI::App* check_app = app.add_subcommand(
      "check", "Validate a case and show what would run: particles, windows, memory, time");
  add_case(*check_app, check_path, check_overrides);
  std::string picture;
  check_app->add_option(
      "--picture", picture,
      "A page for a browser that shows the case: FILE.html, with tank, water, bodies, clamps, "
      "probes and the paths of walls");

  std::string status_folder;
  CLI::App* status_app = app.add_subcommand(
      "status", "How far a run is, how fast, and how to go on with it, from its folder alone");
  status_app->add_option("folder", status_folder, "Folder of its results")->required();

  CLI::App* selftest_app = app.add_subcommand(
      "selftest", "Water on a sprung piston against its exact frequency and limit of stability");

  cosurge::CertifyOptions certify;
  std::string role = "solid";
  CLI::App* certify_app = app.add_subcommand(
      "certify", "Whether a solver program keeps the protocol: cosurge certify -- PROGRAM ARGUMENTS");
  certify_app->add_option("command", certify.command, "The program and its arguments, after --")->required();
  certify_app->add_option("--set", certify.overrides, "Values in place of the scene's (solid.model=fem)");
  certify_app->add_option("--role", role, "What it solves")
      ->check(CLI::IsMember({"fluid", "solid"}))
      ->capture_default_str();
  certify_app->add_option("--patience", certify.patience, "Longest wait for an answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();

  cosurge::MapOptions map;
  CLI::App* map_app =
      app.add_subcommand("map", "Run a case over a grid of its values, and say where it is stable");
  add_case(*map_app, map.case_path, map.overrides);
  map_app
      ->add_option(
          "--over", map.over,
          "An axis of the grid: key.path=value,value,...; key/key=value/value,... changes keys together; "
          "a vector is one value: gravity=[0,-9.81],[0,-1.62]")
      ->required()
      ->take_all();
  map_app->add_option("--out", map.out, "The table, CSV; a map that was interrupted goes on")->required();
  map_app->add_option("--cores", map.cores, "Runs at a time; 0: one a core")->check(CLI::Range(0, 1024));
  cosurge::CsvOptions csv;
  CLI::App* csv_app = app.add_subcommand("csv", "Write the histories of a run as a table, with units");
  csv_app->add_option("results", csv.results, "Folder of the results, or its results.h5")->required();
  csv_app->add_option("--columns", csv.columns, "Histories to write (fluid/front solid/tip_x); default: all")
      ->take_all();
  csv_app->add_option("--out", csv.out, "The table (default: standard output)");

  cosurge::ReportOptions report;
  CLI::App* report_app = add_report(app, report);
  cosurge::WatchOptions watch;
  CLI::App* watch_app = add_watch(app, watch);

  if (argc > 1 && argv[1][0] != '-') {
    if (const std::string wrong = unknown_command(app, argv[1]); !wrong.empty()) {
      std::cerr << cosurge::printable(wrong) << '\n';
      return 2;
    }
  }
  for (int k = 1; k < argc; ++k) map.note += (k > 1 ? " " : "cosurge ") + std::string(argv[k]);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    if (*run_app) return cosurge::run_command(run);
    if (*status_app) {
      cosurge::say("{}", cosurge::status_of(status_folder));
      return 0;
    }
    if (*selftest_app) return cosurge::selftest_command();
    if (*certify_app) {
      certify.role = role == "fluid" ? cosurge::Role::fluid : cosurge::Role::solid;
      return cosurge::certify_command(certify);
    }
    if (*map_app) return cosurge::map_command(map);
    if (*csv_app) {
      cosurge::csv_command(csv);
      return 0;
    }
    if (*watch_app) return cosurge::watch_command(watch);
    if (*report_app) {
      cosurge::report_command(report);
      return 0;
    }
    if (*resume_app) return cosurge::resume_command(resume);
    cosurge::check_command(check_path, check_overrides, picture);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << cosurge::printable(error.what()) << '\n';
    return 1;
  }
}
