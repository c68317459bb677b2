#include "coupler/checkpoint.hpp"

#include <H5Cpp.h>
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "common/version.hpp"
#include "coupler/build_id.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/result_file.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

constexpr int layout = 5;  // version of saved states: increase it when their content or order changes

std::string signature() { return fmt::format("cosurge checkpoint {}, layout {}", version, layout); }

constexpr std::string_view mark = "cosurge checkpoint, sealed\n";

std::uint32_t checksum(std::initializer_list<std::string_view> parts) {
  uLong sum = crc32_z(0, nullptr, 0);
  for (const std::string_view part : parts)
    sum = crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()), part.size());
  return static_cast<std::uint32_t>(sum);
}

/// The content of a checkpoint file, after the check of its length and checksum. @throws Error
std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  require(file.is_open(), "{}: cannot be read", path.string());
  std::ostringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  require(all.starts_with(mark), "{}: is not a checkpoint of cosurge {}, or is damaged", path.string(),
          version);
  std::uint64_t length = 0;
  std::uint32_t sum = 0;
  constexpr std::size_t seal = sizeof length + sizeof sum;
  const std::string_view sealed = std::string_view(all).substr(mark.size());
  require(sealed.size() >= seal, "{}: is damaged: it ends after {} bytes", path.string(), all.size());
  StateReader head(sealed.substr(0, seal));
  head.get(length);
  head.get(sum);
  const std::string_view content = sealed.substr(seal);
  require(content.size() == length, "{}: is damaged: it has {} bytes instead of {}", path.string(),
          content.size(), length);
  const std::uint32_t found = checksum({content});
  require(found == sum, "{}: is damaged: its checksum is {:08x} instead of {:08x}", path.string(), found,
          sum);
  return std::string(content);
}

Checkpoint decode(const std::string& content, const std::filesystem::path& path) {
  StateReader bytes(content);
  std::string found;
  bytes.get(found);
  require(
      found == signature(),
      "{}: it was written by another version, \"{}\"; this is \"{}\": resume with the version that wrote it",
      path.string(), found, signature());
  Checkpoint checkpoint;
  std::string serialized;
  std::uint64_t count = 0;
  bytes.get(checkpoint.build);
  bytes.get(count);
  for (std::uint64_t k = 0; k < count; ++k) {
    Checkpoint::Solver solver;
    for (std::string* word : {&solver.name, &solver.program, &solver.version}) bytes.get(*word);
    checkpoint.solvers.push_back(solver);
  }
  bytes.get(serialized);
  bytes.get(checkpoint.time);
  bytes.get(checkpoint.windows);
  bytes.get(checkpoint.frames);
  bytes.get(checkpoint.state);
  bytes.finish();
  require(checkpoint.the_case.ParseFromString(serialized), "{}: its case cannot be read", path.string());
  return checkpoint;
}

/// Checks that a dataset reaches as far as the checkpoint says.
std::vector<hsize_t> require_length(const H5::DataSet& dataset, const std::string& name, std::uint64_t needed,
                                    const Checkpoint& checkpoint) {
  std::vector<hsize_t> size = extent(dataset);
  require(!size.empty() && size[0] >= needed,
          "{} has {} entries, the checkpoint at t = {:.6g} s needs {}: a part of the results is missing, and "
          "the run cannot be resumed; run the case again with another --out",
          name, size.empty() ? 0 : size[0], checkpoint.time, needed);
  return size;
}

/// The first `rows` of a series.
std::vector<double> column(const H5::H5File& file, const std::string& name, std::uint64_t rows,
                           const Checkpoint& checkpoint) {
  const H5::DataSet dataset = file.openDataSet(name);
  require_length(dataset, name, rows, checkpoint);
  return first_rows(dataset, rows);
}

/// Checks that an array has frames as the recorder writes them, and no more numbers than the memory of a
/// large machine.
void require_frames(const std::vector<hsize_t>& size, const std::string& place) {
  constexpr hsize_t most = hsize_t{1} << 32;
  const bool array = size.size() == 2 || (size.size() == 3 && size[2] > 0);
  require(array, "{} has {} dimensions, or nothing in the last: it is not an array of Cosurge", place,
          size.size());
  const hsize_t components = size.size() == 3 ? size[2] : 1;
  require(components <= most && size[1] <= most / components,
          "{} has frames of {} x {} numbers, an array of Cosurge has {} at most", place, size[1], components,
          most);
}

/// Frame `index` of one array.
Array frame_of(const H5::Group& group, const std::string& name, hsize_t index, const Checkpoint& checkpoint) {
  const H5::DataSet dataset = group.openDataSet(name);
  const std::string place = dataset.getObjName();
  std::vector<hsize_t> size = require_length(dataset, place, checkpoint.frames, checkpoint);
  require_frames(size, place);
  std::vector<hsize_t> start(size.size(), 0);
  start[0] = index;
  size[0] = 1;
  Array array{
      .name = name, .unit = "", .components = size.size() == 3 ? static_cast<int>(size[2]) : 1, .values = {}};
  array.values.resize(size[1] * static_cast<hsize_t>(array.components));
  H5::DataSpace source = dataset.getSpace();
  source.selectHyperslab(H5S_SELECT_SET, size.data(), start.data());
  dataset.read(array.values.data(), H5::PredType::NATIVE_FLOAT,
               H5::DataSpace(static_cast<int>(size.size()), size.data()), source);
  if (dataset.attrExists("unit")) array.unit = text_of(dataset.openAttribute("unit"));
  return array;
}

Snapshot snapshot(const H5::H5File& file, const std::string& member, hsize_t index,
                  const Checkpoint& checkpoint) {
  const H5::Group group = file.openGroup("/frames/" + member);
  Snapshot arrays;
  for (hsize_t k = 0; k < group.getNumObjs(); ++k)
    arrays.push_back(frame_of(group, group.getObjnameByIdx(k), index, checkpoint));
  return arrays;
}

/// Checks that the histories end at the time of the checkpoint, which those of another run do not. The end of
/// a window differs from the time of its frame by the rounding error of a sum.
void require_same_end(const std::vector<std::vector<double>>& columns, const Checkpoint& checkpoint) {
  if (checkpoint.windows == 0) return;
  const double time = columns[0].back(), window = columns[1].back();
  require(std::abs(time - checkpoint.time) < 0.5 * window,
          "row {} is at t = {:.9g} s, the checkpoint says {:.9g} s: results and checkpoint belong to "
          "different runs; put the files of one run together, or run the case again with another --out",
          checkpoint.windows, time, checkpoint.time);
}

void replay_file(const H5::H5File& file, const Checkpoint& checkpoint, Recorder& recorder) {
  std::vector<std::vector<double>> columns;
  for (const History& history : recorder.histories())
    columns.push_back(column(file, "/history/" + history.name(), checkpoint.windows, checkpoint));
  require_same_end(columns, checkpoint);
  const std::vector<double> frame_times = column(file, "/frames/time", checkpoint.frames, checkpoint);
  std::size_t row = 0;
  const auto next_row = [&] {
    std::vector<double> values;
    for (const auto& one : columns) values.push_back(one[row]);
    recorder.row(values);
    ++row;
  };
  const std::vector<double>& ends = columns[0];
  const std::vector<double>& windows = columns[1];
  for (std::size_t frame = 0; frame < frame_times.size(); ++frame) {
    // No frame lies within a window: half a window is more than any rounding error.
    while (row < ends.size() && ends[row] - 0.5 * windows[row] < frame_times[frame]) next_row();
    std::vector<Snapshot> snapshots;
    for (const Member& member : recorder.members())
      snapshots.push_back(snapshot(file, member.name, frame, checkpoint));
    recorder.frame(frame_times[frame], snapshots);
  }
  while (row < ends.size()) next_row();
}

}  // namespace

void Checkpoint::write(const std::filesystem::path& folder) const {
  StateWriter head;
  head.put(signature());
  head.put(build);
  head.put(static_cast<std::uint64_t>(solvers.size()));
  for (const Solver& solver : solvers)
    for (const std::string* word : {&solver.name, &solver.program, &solver.version}) head.put(*word);
  head.put(the_case.SerializeAsString());
  head.put(time);
  head.put(windows);
  head.put(frames);
  head.put(static_cast<std::uint64_t>(state.size()));  // written as put(string) does, without a copy
  const std::string content = head.take();
  StateWriter seal;
  seal.put(static_cast<std::uint64_t>(content.size() + state.size()));
  seal.put(checksum({content, state}));
  // The previous one stays under a second name (a hard link), if the file system supports it.
  const std::filesystem::path kept = folder / (std::string(name_before) + ".new");
  std::error_code none;
  std::filesystem::remove(kept, none);
  std::filesystem::create_hard_link(folder / name, kept, none);
  replace_file(folder / name, {mark, seal.take(), content, state});
  std::filesystem::rename(kept, folder / name_before, none);
}

Checkpoint Checkpoint::read_file(const std::filesystem::path& path) { return decode(content_of(path), path); }

Checkpoint Checkpoint::read(const std::filesystem::path& folder) {
  const std::filesystem::path last = folder / name, before = folder / name_before;
  const bool some = std::filesystem::exists(last) || std::filesystem::exists(before);
  require(some, "{}: no checkpoint to resume from", last.string());
  std::string content;
  try {
    content = content_of(last);
  } catch (const Error& damage) {
    try {
      content = content_of(before);
    } catch (const Error& second) {
      throw Error(fmt::format("{}; {}: the run cannot be resumed; run the case again with another --out",
                              damage.what(), second.what()));
    }
    say("warning: {}; the previous checkpoint is used\n", damage.what());
    std::filesystem::rename(before, last);
  }
  Checkpoint checkpoint = decode(content, last);
  if (checkpoint.build != build_id())
    say("warning: {} was written by another build of cosurge {} ({:.12}, this is {:.12}): the last digits "
        "may differ from those of an uninterrupted run\n",
        last.string(), version, checkpoint.build, build_id());
  return checkpoint;
}

void Checkpoint::require_same_programs(const std::vector<Member>& members) const {
  require(members.size() == solvers.size(), "the checkpoint has {} solvers, the case has {}", solvers.size(),
          members.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Identity& here = members[k].identity;
    require(here.program == solvers[k].program && here.version == solvers[k].version,
            "the state of the {0} in the checkpoint was written by {1} {2}, but the {0} solver is {3} {4}: "
            "resume with the program of the run (--{0} PROGRAM or --by-hand {0}, if it is not Cosurge's own)",
            solvers[k].name, solvers[k].program, solvers[k].version, here.program, here.version);
  }
}

void CheckpointWriter::write() {
  std::vector<Checkpoint::Solver> solvers;
  for (const Member& member : coupler_.members())
    solvers.push_back({member.name, member.identity.program, member.identity.version});
  Checkpoint{.build = build_id(),
             .solvers = std::move(solvers),
             .the_case = case_,
             .time = coupler_.time(),
             .windows = coupler_.windows(),
             .frames = coupler_.frames(),
             .state = coupler_.save()}
      .write(folder_);
  time_ = coupler_.time();
}

void replay(const std::filesystem::path& results, const Checkpoint& checkpoint, Recorder& recorder) {
  try {
    replay_file(H5::H5File(results.string(), H5F_ACC_RDONLY), checkpoint, recorder);
  } catch (const H5::Exception& exception) {  // not a std::exception
    throw Error(fmt::format("{}: cannot be read: {}", results.string(), exception.getDetailMsg()));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", results.string(), error.what()));
  }
}

}  // namespace cosurge
