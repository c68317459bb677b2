// Commands that look at a case before its run.
#include <memory>

#include "coupler/advise/advise_command.hpp"
#include "coupler/check_command.hpp"
#include "coupler/command_line/command.hpp"

namespace cosurge {
namespace {

/// A case, and the picture to draw of it.
struct CheckOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  std::string picture;
};

}  // namespace

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

Command add_check(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Validate a case and estimate its particles, windows, memory and time");
  add_case(*command, options->case_path, options->overrides);
  command->add_option("--picture", options->picture,
                      "Draw the case before its run: tank, water, bodies, clamps, supports, probes, moving "
                      "walls at their extremes. FILE.png is a picture, FILE.html a page for a browser");
  return {command, [options] {
            check_command(options->case_path, options->overrides, options->picture);
            return 0;
          }};
}

Command add_advise(CLI::App& app) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "advise", "Show the numbers of a scene, and the structural model and coupling scheme that suit it");
  add_case(*command, options->case_path, options->overrides);
  return {command, [options] {
            advise_command(options->case_path, options->overrides);
            return 0;
          }};
}

}  // namespace cosurge
