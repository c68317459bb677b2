// cosurge report: runs as one page for a browser.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Options of cosurge report.
struct ReportOptions {
  std::vector<std::string> results;  ///< folders of results, or their results.h5
  std::string out;                   ///< the page; empty: report.html in the first folder
  std::string case_folder;  ///< folder with reference/*.csv; empty: the folders that the results name
  double megabytes = 5;     ///< approximate size of the page [MB]
  std::string video;        ///< an MP4 in place of the page; empty: none
};

/// The page as text. @throws as report_command().
std::string report_page(const ReportOptions& options);

/// Writes the page, and says where. The one in a folder of results is replaced; a file that `out` names must
/// not exist. Works during the run, and after it was killed.
/// @throws Error, with all that is wrong, where there are no results, or the page exists or cannot be
/// written.
void report_command(const ReportOptions& options);

}  // namespace cosurge
