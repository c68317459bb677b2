// cosurge: launches the solvers of a case, couples them and records the results.
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "common/threads.hpp"
#include "common/version.hpp"
#include "common/wire/wire_words.hpp"
#include "coupler/advise/advise_command.hpp"
#include "coupler/certify_command.hpp"
#include "coupler/chart/chart_command.hpp"
#include "coupler/check_command.hpp"
#include "coupler/csv_command.hpp"
#include "coupler/keys_command.hpp"
#include "coupler/map_command.hpp"
#include "coupler/report/report_command.hpp"
#include "coupler/report/watch_command.hpp"
#include "coupler/run_command.hpp"
#include "coupler/say.hpp"
#include "coupler/selftest_command.hpp"
#include "coupler/status_command.hpp"

namespace {

void add_case(CLI::App& command, std::string& path, std::vector<std::string>& overrides) {
  command.add_option("case", path, "Folder with a case.toml, or the file itself")->required();
  command
      .add_option(
          "--set", overrides,
          "Override values of the case: key.path=value, with the index for entries of lists "
          "(fluid.spacing=0.001 solid.model=rigid output.probe.0.name=top); the word none removes a key: "
          "time.window=none")
      ->take_all();
}

/// How the solvers are started, which does not change the answer.
void add_solvers(CLI::App& command, cosurge::RunOptions& options) {
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

CLI::App* add_report(CLI::App& app, cosurge::ReportOptions& report) {
  CLI::App* command =
      app.add_subcommand("report", "Write an HTML page with an animation, histories and tables");
  command->add_option("results", report.results, "Folders of results; several are shown together")
      ->required();
  command->add_option("--out", report.out, "The page (default: report.html in the first folder)");
  command->add_option("--case", report.case_folder,
                      "Folder with reference/*.csv (default: the case folder named in the results)");
  command
      ->add_option("--size", report.megabytes,
                   "Approximate size of the page [MB]: a smaller page has fewer frames or particles")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
  return command;
}

CLI::App* add_watch(CLI::App& app, cosurge::WatchOptions& watch) {
  CLI::App* command =
      app.add_subcommand("watch", "Show a running case in a browser on this machine, with the time left");
  command->add_option("results", watch.results, "Folders of results; several are shown together")->required();
  command->add_option("--port", watch.port, "Port on 127.0.0.1 (default: any free port)")
      ->check(CLI::Range(1, 65535));
  command
      ->add_option("--size", watch.megabytes,
                   "Approximate size of the page [MB]: a smaller page has fewer frames or particles")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
  return command;
}

CLI::App* add_chart(CLI::App& app, cosurge::ChartOptions& chart) {
  CLI::App* command = app.add_subcommand(
      "chart", "Run a case with many settings, and tabulate the error of each against its cost");
  add_case(*command, chart.case_path, chart.overrides);
  command
      ->add_option("--over", chart.over,
                   "Values of a key to compare: key.path=value,value,...; several options: all combinations; "
                   "key/key=value/value,... changes keys together; none is the key's default")
      ->take_all();
  command->add_option(
      "--plan", chart.plan,
      "Settings to compare, CSV: a key a column, a run a row; an empty cell leaves the case's "
      "own value");
  command
      ->add_option("--quantity", chart.quantities,
                   "What to compare: peak(H), time_of_peak(H), impulse(H), rms(H); H is a probe's column "
                   "(P01, tip.x), a column of the results (fluid/front) or a difference (left-right); with a "
                   "range of time: peak(tip.x, 0.1..0.4)")
      ->required()
      ->take_all();
  command
      ->add_option("--truth", chart.truth,
                   "finest: the dearest run (default); KEY=VALUE ...: the run with these settings; FILE.csv: "
                   "a curve, two columns time [s] and value; QUANTITY=FILE.csv; QUANTITY=NUMBER")
      ->take_all();
  command
      ->add_option("--scatter", chart.scatter,
                   "Number of perturbed starts of each run: gravity times 1 + 1e-6 k; the error is then the "
                   "rms over all starts")
      ->check(CLI::Range(0, 100));
  command
      ->add_option("--cores", chart.cores,
                   "Number of simultaneous runs; more than one makes the costs less exact")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--out", chart.out, "Folder of the chart; an interrupted chart is continued")
      ->required();
  return command;
}

/// A word of a command line as it must be typed: in quotes where the shell would read it in another way.
std::string shell_word(const std::string& word) {
  const bool plain = word.find_first_of(" \t\n\"'`$&|;<>()[]{}*?!#~\\") == std::string::npos && !word.empty();
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
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
  return fmt::format(
      "cosurge {}: no such command{}. The commands are {}; cosurge COMMAND --help explains one", word,
      near ? fmt::format(", did you mean cosurge {}?", *nearest) : "", fmt::join(names, ", "));
}

}  // namespace

int main(int argc, char** argv) {
  cosurge::ensure_passive_waiting(argv);
  CLI::App app("Cosurge simulates wave impacts on elastic structures, with coupling in both directions.",
               "cosurge");
  app.set_version_flag("--version", std::string("cosurge ") + cosurge::version);
  app.require_subcommand(1);

  cosurge::RunOptions run;
  CLI::App* run_app =
      app.add_subcommand("run", "Run a case: start its solvers, couple them, write the results");
  add_case(*run_app, run.case_path, run.overrides);
  run_app->add_option("--out", run.out,
                      "Folder of the results (default: results/NAME, with a number if it exists)");
  add_solvers(*run_app, run);
  run_app
      ->add_option(
          "--fault", run.faults,
          "Let a solver fail: KIND:SOLVER@TIME, for instance kill:solid@0.05 with the time in s; kill or "
          "freeze its process, delay its answer by 5 s, or corrupt its answer")
      ->take_all();

  cosurge::RunOptions resume;
  CLI::App* resume_app = app.add_subcommand("resume",
                                            "Continue a run that was interrupted, failed or was killed, from "
                                            "its last frame; or extend a finished run");
  resume_app->add_option("folder", resume.out, "Folder of its results")->required();
  resume_app
      ->add_option("--set", resume.overrides,
                   "Override values of time, coupling, output.frame_interval, fluid.courant, fluid.pressure "
                   "and fluid.most_lost (time.end=2 coupling.scheme=strong)")
      ->take_all();
  add_solvers(*resume_app, resume);

  std::string check_path;
  std::vector<std::string> check_overrides;
  CLI::App* check_app =
      app.add_subcommand("check", "Validate a case and estimate its particles, windows, memory and time");
  add_case(*check_app, check_path, check_overrides);
  std::string picture;
  check_app->add_option("--picture", picture,
                        "Write an HTML page of the case to FILE.html: tank, water, bodies, clamps, probes "
                        "and the paths of walls");

  std::string advise_path;
  std::vector<std::string> advise_overrides;
  CLI::App* advise_app = app.add_subcommand(
      "advise", "Show the numbers of a scene, and the structural model and coupling scheme that suit it");
  add_case(*advise_app, advise_path, advise_overrides);

  std::string status_folder;
  CLI::App* status_app =
      app.add_subcommand("status", "Show the progress and speed of a run, and how to resume it");
  status_app->add_option("folder", status_folder, "Folder of its results")->required();

  CLI::App* keys_app = app.add_subcommand(
      "keys", "Show the public key of this machine, for runs across machines; make its keys if it has none");

  CLI::App* selftest_app = app.add_subcommand(
      "selftest",
      "Compare the coupling with theory: frequency and stability limit of water on a sprung piston");

  cosurge::CertifyOptions certify;
  std::string role = "solid";
  CLI::App* certify_app = app.add_subcommand(
      "certify", "Check protocol conformance of a solver program: cosurge certify -- PROGRAM ARGUMENTS");
  certify_app->add_option("command", certify.command, "The program and its arguments, after --")->required();
  certify_app->add_option("--set", certify.overrides, "Override values of the test scene (solid.model=fem)");
  certify_app->add_option("--role", role, "What it solves")
      ->check(CLI::IsMember({"fluid", "solid"}))
      ->capture_default_str();
  certify_app->add_option("--patience", certify.patience, "Longest wait for an answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();

  cosurge::MapOptions map;
  CLI::App* map_app =
      app.add_subcommand("map", "Run a case over a grid of values, and tabulate its stability");
  add_case(*map_app, map.case_path, map.overrides);
  map_app
      ->add_option("--over", map.over,
                   "One axis of the grid: key.path=value,value,...; key/key=value/value,... changes keys "
                   "together; a vector is one value: gravity=[0,-9.81],[0,-1.62]")
      ->required()
      ->take_all();
  map_app->add_option("--out", map.out, "The table, CSV; an interrupted map is continued")->required();
  map_app->add_option("--cores", map.cores, "Number of simultaneous runs; 0: one per core")
      ->check(CLI::Range(0, 1024));
  cosurge::ChartOptions chart;
  CLI::App* chart_app = add_chart(app, chart);

  cosurge::CsvOptions csv;
  CLI::App* csv_app = app.add_subcommand("csv", "Write the histories of a run as a CSV table, with units");
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
  for (int k = 1; k < argc; ++k) map.note += (k > 1 ? " " : "cosurge ") + shell_word(argv[k]);
  chart.note = map.note;

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
    if (*keys_app) {
      cosurge::say("{}", cosurge::keys_command());
      return 0;
    }
    if (*advise_app) {
      cosurge::advise_command(advise_path, advise_overrides);
      return 0;
    }
    if (*selftest_app) return cosurge::selftest_command();
    if (*certify_app) {
      certify.role = role == "fluid" ? cosurge::Role::fluid : cosurge::Role::solid;
      return cosurge::certify_command(certify);
    }
    if (*map_app) return cosurge::map_command(map);
    if (*chart_app) return cosurge::chart_command(chart);
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
