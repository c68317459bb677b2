// The commands of the program cosurge: their options, and what they do.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace cosurge {

/// A command: its help text, its options, and the function that runs it and returns the exit status.
struct Command {
  CLI::App* app;
  std::function<int()> act;
};

// Each adds a command with its options. `note` is the command line as it was typed, for the tables.

Command add_run(CLI::App& app);
Command add_resume(CLI::App& app);
Command add_status(CLI::App& app);
Command add_keys(CLI::App& app);
Command add_selftest(CLI::App& app);
Command add_certify(CLI::App& app);

Command add_check(CLI::App& app);
Command add_advise(CLI::App& app);

Command add_map(CLI::App& app, const std::string& note);
Command add_chart(CLI::App& app, const std::string& note);
Command add_sweep(CLI::App& app, const std::string& note);
Command add_converge(CLI::App& app, const std::string& note);

Command add_csv(CLI::App& app);
Command add_report(CLI::App& app);
Command add_watch(CLI::App& app);

/// The arguments CASE and --set, which many commands have.
void add_case(CLI::App& command, std::string& path, std::vector<std::string>& overrides);

}  // namespace cosurge
