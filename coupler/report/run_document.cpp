#include "coupler/report/run_document.hpp"

#include <fmt/chrono.h>
#include <fmt/ranges.h>

#include <cmath>
#include <ctime>

#include "common/case/bodies.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "coupler/provenance.hpp"
#include "coupler/report/case_table.hpp"
#include "coupler/report/outlines.hpp"
#include "coupler/report/packed_histories.hpp"
#include "coupler/report/reference_curves.hpp"
#include "coupler/report/run_numbers.hpp"
#include "coupler/shell_word.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string command_of(const Provenance& provenance) {
  if (provenance.case_file.empty()) return "";
  std::vector<std::string> words = {"cosurge", "run", shell_word(provenance.case_file)};
  if (!provenance.overrides.empty()) words.emplace_back("--set");
  for (const std::string& change : provenance.overrides) words.push_back(shell_word(change));
  return fmt::format("{}", fmt::join(words, " "));
}

Json facts(const Results& results, const v1::Case& the_case, const Provenance& provenance) {
  Json rows = Json::array();
  const auto add = [&](const std::string& name, const std::string& text) {
    if (!text.empty()) rows.push_back({name, text});
  };
  add("case", the_case.title());
  add("reference", the_case.reference());
  add("command", command_of(provenance));
  for (const std::string& change : provenance.changes) add("changed when resumed", change);
  add("begun", results.attribute("date"));
  add("cosurge", results.attribute("cosurge"));
  add("fluid", results.attribute("fluid"));
  add("solid", results.attribute("solid"));
  add("results", fs::absolute(results.file()).lexically_normal().string());
  return rows;
}

}  // namespace

RunDocument::RunDocument(const fs::path& results, const DocumentOptions& options)
    : place_(results), options_(options) {
  Results{place_};
}

bool RunDocument::has_news(std::size_t frames, std::size_t windows, const std::string& state) const {
  const Results results(place_);
  const std::size_t every = choice_ ? choice_->every_frame : 1;
  const std::size_t shown = (results.frame_times().size() + every - 1) / every;
  const std::size_t rows = results.history("time").values.size();
  return shown != frames || rows != windows || state_of(summary_of(results, rows)) != state;
}

Json RunDocument::scene(const Results& results, const v1::Case& the_case, std::size_t first_frame) {
  const std::vector<double> times = results.frame_times();
  if (times.empty())
    return {{"times", Json::array()}, {"chunks", Json::array()}, {"outlines", outlines(the_case, {})}};
  const RecordedFrames fluid(results, "fluid"), solid(results, "solid");
  if (!choice_) {
    const double all = the_case.time().end() / the_case.output().frame_interval();
    choice_ = choose(the_case, fluid, solid, std::max(times.size(), static_cast<std::size_t>(std::ceil(all))),
                     options_.megabytes);
  }
  std::vector<double> shown;
  for (std::size_t k = 0; k < times.size(); k += choice_->every_frame) shown.push_back(times[k]);
  return {{"times", shown},
          {"every_frame", choice_->every_frame},
          {"every_particle", choice_->every_particle},
          {"spacing",
           {{"fluid", the_case.fluid().spacing()},
            {"solid", the_case.has_solid() ? solid_spacing(the_case) : 0}}},
          {"outlines", outlines(the_case, shown)},
          {"chunks", chunks(*choice_, fluid, solid, first_frame * choice_->every_frame, times.size())}};
}

Json RunDocument::read(std::size_t first_frame) {
  const Results results(place_);
  const v1::Case the_case = results.the_case();
  const RunRecord run(results);
  const Provenance provenance = Provenance::of_results(results.file());
  const fs::path case_folder =
      options_.case_folder.empty() ? fs::path(provenance.case_file).parent_path() : options_.case_folder;
  return {{"name", fs::absolute(results.folder()).lexically_normal().filename().string()},
          {"title", the_case.title()},
          {"dimension", the_case.dimension()},
          {"status", status(run, the_case)},
          {"verdict", verdict(run, the_case)},
          {"facts", facts(results, the_case, provenance)},
          {"case", case_table(the_case)},
          {"tables", pack_histories(run, the_case)},
          {"extremes", extremes(run, the_case)},
          {"impulses", impulses(run, the_case)},
          {"balance", balance(run)},
          {"phases", phases(run)},
          {"references", reference_curves(case_folder, the_case)},
          {"first_frame", first_frame},
          {"scene", scene(results, the_case, first_frame)}};
}

Json page_document(const std::string& mode, Json runs) {
  for (const Json& run : runs)
    require(run["dimension"] == runs[0]["dimension"],
            "{} has {} dimensions, {} has {}: they cannot be shown together; make one page for each",
            runs[0]["name"].get<std::string>(), runs[0]["dimension"].get<int>(),
            run["name"].get<std::string>(), run["dimension"].get<int>());
  return {{"made", fmt::format("{:%Y-%m-%d %H:%M UTC}", fmt::gmtime(std::time(nullptr)))},
          {"cosurge", std::string(version)},
          {"mode", mode},
          {"runs", std::move(runs)}};
}

}  // namespace cosurge
