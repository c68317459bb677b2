// summary.json: how a run went, on one page.
#pragma once

#include <filesystem>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "coupler/recorder.hpp"

namespace cosurge {

/// How a run ended.
struct Outcome {
  std::string status;        ///< "finished", "interrupted" or "failed"
  std::string reason;        ///< why it did not finish
  bool broken_down = false;  ///< the computation itself failed: the same run would fail again
  double exchange_seconds = std::numeric_limits<double>::quiet_NaN();  ///< [s] wall time of the exchange of
                                                                       ///< messages, without computing
};

/// Writes summary.json into `folder`. Unknown or non-finite values are null.
/// @throws Error when it cannot be written.
void write_summary(const std::filesystem::path& folder, const Recorder& recorder, const Outcome& outcome);

/// The summary.json in a folder; null if there is none, or if it cannot be read.
nlohmann::json summary_in(const std::filesystem::path& folder);

}  // namespace cosurge
