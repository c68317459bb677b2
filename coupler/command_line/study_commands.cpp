// Commands that run a case many times.
#include <memory>

#include "coupler/chart/chart_command.hpp"
#include "coupler/command_line/command.hpp"
#include "coupler/converge/converge_command.hpp"
#include "coupler/map_command.hpp"
#include "coupler/sweep/sweep_command.hpp"

namespace cosurge {
namespace {

constexpr const char* quantity_words =
    "What to tabulate: peak(H), time_of_peak(H), impulse(H), rms(H); H is a probe's column (P01, tip.x), a "
    "column of the results (fluid/front) or a difference (left-right); with a range of time: peak(tip.x, "
    "0.1..0.4)";

/// The case, its settings, the quantities and the folder. Returns the option of the quantities.
CLI::Option* add_study(CLI::App& command, StudyOptions& options) {
  add_case(command, options.case_path, options.overrides);
  command
      .add_option("--over", options.over,
                  "Values of a key to compare: key.path=value,value,...; several options: all combinations; "
                  "key/key=value/value,... changes keys together; none is the key's default")
      ->take_all();
  command.add_option("--plan", options.plan,
                     "Settings to compare, CSV: a key a column, a run a row; an empty cell leaves the case's "
                     "own value");
  command
      .add_option("--cores", options.cores,
                  "Number of simultaneous runs; more than one makes the costs less exact")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      .add_option("--out", options.out,
                  "Folder of the table and the runs; an interrupted command is continued")
      ->required();
  return command.add_option("--quantity", options.quantities, quantity_words)->take_all();
}

}  // namespace

Command add_map(CLI::App& app, const std::string& note) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* command =
      app.add_subcommand("map", "Run a case over a grid of values, and tabulate its stability");
  add_case(*command, options->case_path, options->overrides);
  command
      ->add_option("--over", options->over,
                   "One axis of the grid: key.path=value,value,...; key/key=value/value,... changes keys "
                   "together; a vector is one value: gravity=[0,-9.81],[0,-1.62]")
      ->required()
      ->take_all();
  command->add_option("--out", options->out, "The table, CSV; an interrupted map is continued")->required();
  command->add_option("--cores", options->cores, "Number of simultaneous runs; 0: one per core")
      ->check(CLI::Range(0, 1024));
  options->note = note;
  return {command, [options] { return map_command(*options); }};
}

Command add_chart(CLI::App& app, const std::string& note) {
  const auto options = std::make_shared<ChartOptions>();
  CLI::App* command = app.add_subcommand(
      "chart", "Run a case with many settings, and tabulate the error of each against its cost");
  add_study(*command, *options)->required();
  command
      ->add_option("--truth", options->truth,
                   "finest: the dearest run (default); KEY=VALUE ...: the run with these settings; FILE.csv: "
                   "a curve, two columns time [s] and value; QUANTITY=FILE.csv; QUANTITY=NUMBER")
      ->take_all();
  command
      ->add_option("--scatter", options->scatter,
                   "Number of perturbed starts of each run: gravity times 1 + 1e-6 k; the error is then the "
                   "rms over all starts")
      ->check(CLI::Range(0, 100));
  options->note = note;
  return {command, [options] { return chart_command(*options); }};
}

Command add_sweep(CLI::App& app, const std::string& note) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* command = app.add_subcommand(
      "sweep", "Run a case over values of its keys, and tabulate peaks, their times and impulses");
  add_study(*command, *options)->description(std::string(quantity_words) + " (default: those of all probes)");
  command->add_flag("--keep", options->keep,
                    "Keep the results of the runs, which are removed once the table is complete");
  options->note = note;
  return {command, [options] { return sweep_command(*options); }};
}

Command add_converge(CLI::App& app, const std::string& note) {
  const auto options = std::make_shared<ConvergeOptions>();
  CLI::App* command = app.add_subcommand(
      "converge", "Find the spacing that an accuracy needs or a budget allows, and run the case with it");
  add_case(*command, options->case_path, options->overrides);
  command
      ->add_option("--quantity", options->quantities,
                   "What must be accurate: peak(H), time_of_peak(H), impulse(H); H is a probe's column (P01, "
                   "tip.x), a "
                   "column of the results (fluid/front) or a difference (left-right); with a range of time: "
                   "peak(tip.x, 0.1..0.4)")
      ->required()
      ->take_all();
  command->add_option("--accuracy", options->accuracy, "Largest relative error: 2% or 0.02");
  command->add_option("--budget", options->budget, "Largest core time of one run: 90s, 10min, 2h");
  command
      ->add_option("--out", options->out,
                   "Folder of the table and the runs; an interrupted command is continued")
      ->required();
  options->note = note;
  return {command, [options] { return converge_command(*options); }};
}

}  // namespace cosurge
