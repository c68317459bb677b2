// Commands that show results.
#include <memory>

#include "coupler/command_line/command.hpp"
#include "coupler/csv_command.hpp"
#include "coupler/report/report_command.hpp"
#include "coupler/report/watch_command.hpp"
#include "coupler/video/video_command.hpp"

namespace cosurge {
namespace {

/// What a page shows, and how large it may be.
void add_page(CLI::App& command, std::vector<std::string>& results, double& megabytes) {
  command.add_option("results", results, "Folders of results; several are shown together")->required();
  command
      .add_option("--size", megabytes,
                  "Approximate size of the page [MB]: a smaller page has fewer frames or particles")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
}

}  // namespace

Command add_csv(CLI::App& app) {
  const auto options = std::make_shared<CsvOptions>();
  CLI::App* command = app.add_subcommand("csv", "Write the histories of a run as a CSV table, with units");
  command->add_option("results", options->results, "Folder of the results, or its results.h5")->required();
  command
      ->add_option("--columns", options->columns,
                   "Histories to write (fluid/front solid/tip_x); default: all")
      ->take_all();
  command->add_option("--out", options->out, "The table (default: standard output)");
  return {command, [options] {
            csv_command(*options);
            return 0;
          }};
}

Command add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "Write an HTML page with an animation, histories and tables");
  add_page(*command, options->results, options->megabytes);
  command->add_option("--out", options->out, "The page (default: report.html in the first folder)");
  command->add_option("--case", options->case_folder,
                      "Folder with reference/*.csv (default: the case folder named in the results)");
  command
      ->add_option("--video", options->video,
                   "Write a video of one run to FILE.mp4 instead of a page; needs ffmpeg")
      ->excludes("--out", "--case", "--size");
  return {command, [options] {
            if (options->video.empty())
              report_command(*options);
            else
              video_command(options->results, options->video);
            return 0;
          }};
}

Command add_watch(CLI::App& app) {
  const auto options = std::make_shared<WatchOptions>();
  CLI::App* command =
      app.add_subcommand("watch", "Show a running case in a browser on this machine, with the time left");
  add_page(*command, options->results, options->megabytes);
  command->add_option("--port", options->port, "Port on 127.0.0.1 (default: any free port)")
      ->check(CLI::Range(1, 65535));
  return {command, [options] { return watch_command(*options); }};
}

}  // namespace cosurge
