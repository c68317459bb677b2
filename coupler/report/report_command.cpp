#include "coupler/report/report_command.hpp"

#include <fmt/ranges.h>

#include "common/error.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/report/page.hpp"
#include "coupler/report/run_document.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_name = "report.html";

/// Where the page goes.
fs::path place_of(const ReportOptions& options) {
  if (!options.out.empty()) return options.out;
  const fs::path results = options.results.front();
  return (fs::is_directory(results) ? results : results.parent_path()) / page_name;
}

}  // namespace

std::string report_page(const ReportOptions& options) {
  std::vector<std::string> wrong;
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  const DocumentOptions document{
      .case_folder = options.case_folder,
      .megabytes = options.megabytes / static_cast<double>(options.results.size())};
  if (!options.out.empty() && fs::exists(options.out))
    wrong.push_back(options.out + ": exists already; choose another --out");
  if (!options.case_folder.empty() && !fs::is_directory(options.case_folder))
    wrong.push_back(options.case_folder + ": no such folder (--case)");
  for (const std::string& results : options.results) {
    try {
      Results::file_at(results);
      read_patiently([&] {
        RunDocument run(results, document);
        runs.push_back(run.read());
      });
    } catch (const Error& error) {
      wrong.push_back(error.what());
    }
  }
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  for (const auto& run : runs)
    for (const auto& curve : run["references"])
      if (curve.contains("error"))
        say("warning: reference curve left out from this line on: {}\n", curve["error"].get<std::string>());
  return page(page_document("report", std::move(runs)));
}

void report_command(const ReportOptions& options) {
  const std::string text = report_page(options);
  const fs::path out = place_of(options);
  replace_file(out, {text});
  say("report: {} ({:.1f} MB)\n", out.string(), 1e-6 * static_cast<double>(text.size()));
}

}  // namespace cosurge
