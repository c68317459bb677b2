#include "coupler/summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "common/case/probe_columns.hpp"
#include "common/case/several_solids.hpp"
#include "common/version.hpp"
#include "coupler/replace_file.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;  // writes numbers that are not finite as null

constexpr std::string_view phase_prefix = "seconds_";

Json last(const Recorder& recorder, const std::string& name) {
  const History* history = recorder.history(name);
  return history ? Json(history->last()) : Json();
}

Json extremes(const History& history) {
  const auto when = [](const History::Extreme& extreme) {
    return Json{{"value", extreme.value}, {"time", extreme.time}};
  };
  return {{"unit", history.unit()},
          {"peak", when(history.peak())},
          {"min", when(history.min())},
          {"max", when(history.max())},
          {"last", history.last()}};
}

/// A probe of a vector has a history for each direction.
Json probes(const Recorder& recorder) {
  Json probes = Json::object();
  const v1::Case& the_case = recorder.the_case();
  for (const v1::Probe& probe : the_case.output().probe())
    for (const std::string& column : probe_columns(probe, the_case.dimension()))
      if (const History* history = recorder.history(probe_group(probe) + "/" + column))
        probes[column] = extremes(*history);
  return probes;
}

/// Seconds of every phase that a group of histories has, and of its processor.
Json seconds(const Recorder& recorder, const std::string& group) {
  Json phases = Json::object();
  const std::string prefix = group + "/" + std::string(phase_prefix);
  for (const History& history : recorder.histories())
    if (history.name().starts_with(prefix)) phases[history.name().substr(prefix.size())] = history.last();
  return {{"phases", phases}, {"cpu", last(recorder, group + "/cpu_seconds")}};
}

/// The values of a solver from the histories of its group ("fluid", "solid", "solid/hull").
void add_effort(const Recorder& recorder, const std::string& group, Json& entry) {
  const History* substeps = recorder.history(group + "/substeps");
  entry["steps"] = substeps ? Json(static_cast<std::uint64_t>(substeps->sum())) : Json(recorder.windows());
  if (recorder.history(group + "/lost")) entry["lost"] = last(recorder, group + "/lost");
  if (const History* deflection = recorder.history(group + "/largest_deflection"))
    entry["largest_deflection"] = deflection->max().value;
  entry["seconds"] = seconds(recorder, group);
}

Json participants(const Recorder& recorder) {
  const v1::Case& the_case = recorder.the_case();
  Json participants = Json::object();
  for (const Member& member : recorder.members()) {
    Json& entry = participants[member.name];
    entry["program"] = member.identity.program;
    entry["version"] = member.identity.version;
    entry["particles"] = member.setup.particles;
    add_effort(recorder, member.name, entry);
    if (member.name == "solid" && has_several_solids(the_case))
      for (const std::string& name : solid_names(the_case))
        add_effort(recorder, "solid/" + name, entry["structures"][name]);
  }
  return participants;
}

/// Values of the coupling: iterations, windows that did not converge, added-mass ratio, created work.
Json coupling(const Recorder& recorder) {
  const History* iterations = recorder.history("coupling/iterations");
  const History* ratio = recorder.history("coupling/added_mass_ratio");
  if (iterations == nullptr || ratio == nullptr) return {};
  return {{"scheme", v1::Coupling::Scheme_Name(recorder.the_case().coupling().scheme())},
          {"work_created", last(recorder, "coupling/work_created")},
          {"iterations", iterations->sum()},
          {"most_iterations", iterations->max().value},
          {"unconverged", last(recorder, "coupling/unconverged")},
          {"added_mass_ratio", ratio->last()},
          {"largest_added_mass_ratio", ratio->max().value}};
}

}  // namespace

void write_summary(const std::filesystem::path& folder, const Recorder& recorder, const Outcome& outcome) {
  const Json summary = {{"status", outcome.status},
                        {"reason", outcome.reason},
                        {"title", recorder.the_case().title()},
                        {"cosurge", version},
                        {"end_time", recorder.time()},
                        {"planned_end_time", recorder.the_case().time().end()},
                        {"windows", recorder.windows()},
                        {"wall_seconds", recorder.wall_seconds()},
                        {"exchange_seconds", outcome.exchange_seconds},
                        {"participants", participants(recorder)},
                        {"interface_work",
                         {{"points", last(recorder, "coupling/work_points")},
                          {"solid", last(recorder, "solid/interface_work")}}},
                        {"coupling", coupling(recorder)},
                        {"probes", probes(recorder)},
                        {"results", {{"hdf5", Recorder::results_name}, {"xdmf", Recorder::xdmf_name}}}};
  constexpr int indent = 2;
  replace_file(folder / "summary.json",
               {summary.dump(indent, ' ', false, Json::error_handler_t::replace), "\n"});
}

nlohmann::json summary_in(const std::filesystem::path& folder) {
  std::ifstream file(folder / "summary.json");
  auto summary = nlohmann::json::parse(file, nullptr, false);
  return summary.is_object() ? summary : nlohmann::json();
}

}  // namespace cosurge
