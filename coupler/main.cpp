// cosurge: launches the solvers of a case, couples them and records the results.
#include <iostream>

#include "common/threads.hpp"
#include "common/version.hpp"
#include "common/wire/wire_words.hpp"
#include "coupler/command_line/command.hpp"
#include "coupler/command_line/words.hpp"
#include "coupler/shell_word.hpp"

namespace {

using cosurge::Command;

/// All commands, in the order of --help.
std::vector<Command> add_commands(CLI::App& app, const std::string& note) {
  return {cosurge::add_run(app),         cosurge::add_resume(app),      cosurge::add_check(app),
          cosurge::add_advise(app),      cosurge::add_status(app),      cosurge::add_keys(app),
          cosurge::add_selftest(app),    cosurge::add_certify(app),     cosurge::add_map(app, note),
          cosurge::add_chart(app, note), cosurge::add_sweep(app, note), cosurge::add_converge(app, note),
          cosurge::add_csv(app),         cosurge::add_report(app),      cosurge::add_watch(app)};
}

}  // namespace

int main(int argc, char** argv) {
  cosurge::ensure_passive_waiting(argv);
  CLI::App app("Cosurge simulates wave impacts on elastic structures, with coupling in both directions.",
               "cosurge");
  app.set_version_flag("--version", std::string("cosurge ") + cosurge::version);
  app.require_subcommand(1);
  std::string note;
  for (int k = 1; k < argc; ++k) note += (k > 1 ? " " : "cosurge ") + cosurge::shell_word(argv[k]);
  const std::vector<Command> commands = add_commands(app, note);
  if (argc > 1 && argv[1][0] != '-') {
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.app->get_name());
    if (const std::string wrong = cosurge::unknown_command(names, argv[1]); !wrong.empty()) {
      std::cerr << cosurge::printable(wrong) << '\n';
      return 2;
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    for (const Command& command : commands)
      if (*command.app) return command.act();
  } catch (const std::exception& error) {
    std::cerr << cosurge::printable(error.what()) << '\n';
  }
  return 1;
}
