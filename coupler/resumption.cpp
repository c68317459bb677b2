#include "coupler/resumption.hpp"

#include <algorithm>
#include <array>

#include "common/case/case_differences.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "coupler/conclusion.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

// Settings that may change at a resumption, because no saved state depends on them: times of windows and
// frames, iterations of pressures and loads, and the limit of lost water.
constexpr std::array may_change = {"time.",         "coupling.",       "output.frame_interval",
                                   "fluid.courant", "fluid.pressure.", "fluid.most_lost"};
constexpr std::size_t most_shown = 10;  // largest number of listed differences

bool may(const std::string& key) {
  return std::any_of(may_change.begin(), may_change.end(),
                     [&](const char* start) { return key.starts_with(start); });
}

/// @throws Error with all changes that are not allowed, and where the end is not later than the checkpoint.
void require_changes(const std::filesystem::path& folder, const Checkpoint& checkpoint, const v1::Case& now,
                     const std::vector<Difference>& changes) {
  std::vector<std::string> wrong;
  for (const Difference& change : changes)
    if (!may(change.key))
      wrong.push_back(
          fmt::format("--set {}: cannot be changed by resume ({}); allowed are time, coupling, "
                      "output.frame_interval, fluid.courant, fluid.pressure and fluid.most_lost",
                      change.key, change.first));
  // A run may have been killed between its last checkpoint and its summary.
  if (now.time().end() <= checkpoint.time && (!changes.empty() || concluded(folder)))
    wrong.push_back(changes.empty()
                        ? fmt::format("the run is finished at t = {:.9g} s; --set time.end=... extends it",
                                      checkpoint.time)
                        : fmt::format("time.end: {} s must be > {:.9g} s, the time already reached",
                                      now.time().end(), checkpoint.time));
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
}

/// Reports differences between the case file and the case of the run.
void tell_of_file(const Provenance& provenance, const v1::Case& begun) {
  if (provenance.case_file.empty() || !std::filesystem::exists(provenance.case_file)) return;
  std::vector<Difference> found;
  try {
    found = differences(begun, load_case(provenance.case_file, provenance.overrides));
  } catch (const std::exception& error) {
    return say(
        "{} can no longer be read as the case of this run, which continues with its original case: {}\n",
        provenance.case_file, error.what());
  }
  std::erase_if(found,
                [](const Difference& d) { return may(d.key); });  // earlier resumptions may have set them
  if (found.empty()) return;
  say("{} has changed since the start of the run, which continues with its original case:\n",
      provenance.case_file);
  for (std::size_t k = 0; k < std::min(found.size(), most_shown); ++k)
    say("  {}: {} in the run, {} in the file\n", found[k].key, found[k].first, found[k].second);
  if (found.size() > most_shown) say("  and {} more\n", found.size() - most_shown);
}

}  // namespace

Resumption resumption_of(const std::filesystem::path& folder, const std::vector<std::string>& overrides) {
  Resumption resumption{.checkpoint = Checkpoint::read(folder),
                        .same_scheme = true,
                        .provenance = Provenance::of_results(folder / Recorder::results_name)};
  Checkpoint& checkpoint = resumption.checkpoint;
  const v1::Case begun =
      change_case(checkpoint.the_case, {});  // the case of the run, with the defaults of newer keys
  if (!overrides.empty()) checkpoint.the_case = change_case(begun, overrides);
  const std::vector<Difference> changes = differences(begun, checkpoint.the_case);
  require_changes(folder, checkpoint, checkpoint.the_case, changes);
  tell_of_file(resumption.provenance, begun);
  for (const Difference& change : changes) {
    const std::string text = fmt::format("{}: {}, now {}", change.key, change.first, change.second);
    say("{}\n", text);
    resumption.provenance.changes.push_back(fmt::format("t = {:.9g} s: {}", checkpoint.time, text));
    if (change.key.starts_with("coupling.")) resumption.same_scheme = false;
  }
  return resumption;
}

}  // namespace cosurge
