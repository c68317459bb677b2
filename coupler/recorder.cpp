#include "coupler/recorder.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cassert>
#include <ctime>
#include <set>

#include "common/error.hpp"
#include "common/version.hpp"
#include "coupler/case_json.hpp"
#include "coupler/lattice_mesh.hpp"
#include "coupler/replace_file.hpp"

namespace cosurge {
namespace {

constexpr std::size_t few_frames = 100;  // up to which the XDMF file is so short that it is always written
constexpr int rest = 50;  // least time between two writings of the XDMF file, over the time that one takes

std::string without_prefix(const std::string& name, const std::string& owner) {
  return name.starts_with(owner + "_") ? name.substr(owner.size() + 1) : name;
}

/// The array of this name, with or without the member's name in front; null if there is no such array.
const Array* find_array(const Snapshot& snapshot, const std::string& member, const std::string& name) {
  const auto found = std::find_if(snapshot.begin(), snapshot.end(), [&](const Array& array) {
    return without_prefix(array.name, member) == name;
  });
  return found == snapshot.end() ? nullptr : &*found;
}

/// The arrays of a first frame. @throws Error where two have one name.
std::vector<XdmfArray> arrays_of(const std::string& member, const Snapshot& first) {
  std::vector<XdmfArray> arrays;
  std::set<std::string> names;
  for (const Array& array : first) {
    const std::string name = without_prefix(array.name, member);
    require(names.insert(name).second, "the {} solver sends two arrays called {}", member, name);
    arrays.push_back({.name = name,
                      .place = fmt::format("/frames/{}/{}", member, name),
                      .particles = array.values.size() / static_cast<std::size_t>(array.components),
                      .components = array.components});
  }
  return arrays;
}

/// Checks that a frame has the arrays of the first one, in any order; otherwise the arrays in the results
/// would have different lengths. @throws Error
void require_same_arrays(const XdmfCloud& cloud, const Snapshot& now) {
  const std::vector<XdmfArray> arrays = arrays_of(cloud.name, now);
  require(arrays.size() == cloud.arrays.size(),
          "the {} solver sends {} arrays in this frame, {} in its first one", cloud.name, arrays.size(),
          cloud.arrays.size());
  for (const XdmfArray& array : arrays) {
    const auto first = std::find_if(cloud.arrays.begin(), cloud.arrays.end(),
                                    [&](const XdmfArray& other) { return other.name == array.name; });
    require(first != cloud.arrays.end(), "the {} solver sends the array {}, which is not in its first frame",
            cloud.name, array.name);
    require(array.particles == first->particles && array.components == first->components,
            "the {} solver sends {} with {} x {} numbers in this frame, {} x {} in its first one", cloud.name,
            array.name, array.particles, array.components, first->particles, first->components);
  }
}

}  // namespace

Recorder::Recorder(const std::filesystem::path& folder, const v1::Case& the_case,
                   const std::vector<Member>& members, const Interface& interface,
                   const std::vector<Column>& coupling_columns, const Provenance& provenance,
                   const std::string& name)
    : folder_(folder), case_(the_case), members_(members), file_(folder / name) {
  describe(provenance);
  histories_.emplace_back("time", "s");
  histories_.emplace_back("window", "s");
  for (const Member& member : members_) {
    for (const Column& column : member.setup.columns)
      histories_.emplace_back(member.name + "/" + column.name, column.unit);
    clouds_.push_back({.name = member.name, .arrays = {}});
  }
  for (const Column& column : coupling_columns)
    histories_.emplace_back("coupling/" + column.name, column.unit);
  for (const History& history : histories_) file_.add_series("/history/" + history.name(), history.unit());
  file_.add_series("/frames/time", "s");
  file_.put("/interface/position", "m", interface.position);
  file_.put("/interface/area", case_.dimension() == 2 ? "m" : "m2", interface.area);
  file_.put("/interface/body", interface.body);
  file_.flush();
}

void Recorder::describe(const Provenance& provenance) {
  file_.describe("format", format);
  file_.describe("cosurge", std::string(version));
  file_.describe("title", case_.title());
  file_.describe("case", as_json(case_));
  file_.describe("case_file", provenance.case_file);
  file_.describe("set", fmt::format("{}", fmt::join(provenance.overrides, "\n")));
  file_.describe("changes", fmt::format("{}", fmt::join(provenance.changes, "\n")));
  file_.describe("date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))));
  for (const Member& member : members_)
    file_.describe(member.name, member.identity.program + " " + member.identity.version);
}

void Recorder::window(const Window& window, const Reports& reports, const std::vector<double>& coupling) {
  assert(reports.size() == members_.size());
  std::vector<double> values = {window.start + window.size, window.size};
  for (const Report& report : reports)
    values.insert(values.end(), report.values.begin(), report.values.end());
  values.insert(values.end(), coupling.begin(), coupling.end());
  row(values);
}

void Recorder::row(const std::vector<double>& values) {
  assert(values.size() == histories_.size());
  time_ = values.front();
  ++windows_;
  for (std::size_t k = 0; k < values.size(); ++k) histories_[k].add(time_, values[k]);
}

Snapshot Recorder::with_displacement(const Snapshot& solid) {
  Snapshot arrays = solid;
  const Array* position = find_array(arrays, "solid", "position");
  if (position == nullptr) return arrays;
  if (frame_times_.empty()) undeformed_ = position->values;
  if (find_array(arrays, "solid", "displacement") != nullptr) return arrays;  // resumed run
  Array displacement{
      .name = "displacement", .unit = "m", .components = position->components, .values = position->values};
  for (std::size_t k = 0; k < std::min(undeformed_.size(), displacement.values.size()); ++k)
    displacement.values[k] -= undeformed_[k];
  arrays.push_back(std::move(displacement));
  return arrays;
}

void Recorder::write_mesh(XdmfCloud& cloud, const Snapshot& first) {
  const Array* position = find_array(first, cloud.name, "position");
  if (position == nullptr) return;
  const std::size_t particles = position->values.size() / static_cast<std::size_t>(position->components);
  const Mesh mesh = cloud.name == "solid" ? lattice_mesh(case_, *position) : points_mesh(particles);
  cloud.mesh = "/mesh/" + cloud.name;
  cloud.cells = mesh.cells();
  cloud.corners = mesh.corners;
  file_.put(cloud.mesh, mesh.connection, mesh.corners);
}

void Recorder::frame(double time, const std::vector<Snapshot>& sent) {
  assert(sent.size() == members_.size());
  std::vector<Snapshot> snapshots = sent;
  for (std::size_t m = 0; m < snapshots.size(); ++m) {
    if (clouds_[m].name == "solid") snapshots[m] = with_displacement(sent[m]);
    if (frame_times_.empty()) clouds_[m].arrays = arrays_of(clouds_[m].name, snapshots[m]);
    require_same_arrays(clouds_[m], snapshots[m]);
  }
  write_waiting();
  for (std::size_t m = 0; m < snapshots.size() && frame_times_.empty(); ++m)
    write_mesh(clouds_[m], snapshots[m]);
  for (std::size_t m = 0; m < snapshots.size(); ++m)
    for (const Array& array : snapshots[m])
      file_.append("/frames/" + clouds_[m].name + "/" + without_prefix(array.name, clouds_[m].name), array);
  file_.append("/frames/time", std::span(&time, 1));
  frame_times_.push_back(time);
  file_.flush();
  xdmf_waits_ = true;
  if (frame_times_.size() <= few_frames || Clock::now() - xdmf_end_ > rest * xdmf_cost_) write_xdmf();
}

void Recorder::flush() {
  write_waiting();
  file_.flush();
  if (xdmf_waits_) write_xdmf();
}

void Recorder::write_xdmf() {
  const auto begin = Clock::now();
  replace_file(folder_ / xdmf_name, {xdmf(results_name, frame_times_, clouds_)});
  xdmf_end_ = Clock::now();
  xdmf_cost_ = xdmf_end_ - begin;
  xdmf_waits_ = false;
}

void Recorder::write_waiting() {
  for (History& history : histories_) file_.append("/history/" + history.name(), history.take_waiting());
}

const History* Recorder::history(const std::string& name) const {
  const auto found = std::find_if(histories_.begin(), histories_.end(),
                                  [&](const History& history) { return history.name() == name; });
  return found == histories_.end() ? nullptr : &*found;
}

double Recorder::wall_seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace cosurge
