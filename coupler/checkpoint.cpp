#include "coupler/checkpoint.hpp"

#include <H5Cpp.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "common/version.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/result_file.hpp"

namespace cosurge {
namespace {

constexpr int layout = 5;  // of states: to be raised whenever what is saved, or its order, changes

std::string signature() { return fmt::format("cosurge checkpoint {}, layout {}", version, layout); }

/// That a dataset reaches as far as the checkpoint says.
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
  std::vector<double> values(require_length(dataset, name, rows, checkpoint)[0]);
  if (!values.empty()) dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
  values.resize(rows);
  return values;
}

/// Frame `index` of one array.
Array frame_of(const H5::Group& group, const std::string& name, hsize_t index, const Checkpoint& checkpoint) {
  const H5::DataSet dataset = group.openDataSet(name);
  std::vector<hsize_t> size = require_length(dataset, "/frames/.../" + name, checkpoint.frames, checkpoint);
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
  if (dataset.attrExists("unit")) {
    const H5::Attribute unit = dataset.openAttribute("unit");
    unit.read(unit.getStrType(), array.unit);
  }
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

/// That rows end where the checkpoint does: of another run they would not. The end of a window is off from
/// the time of its frame by the rounding of a sum.
void require_same_end(const std::vector<std::vector<double>>& columns, const Checkpoint& checkpoint) {
  if (checkpoint.windows == 0) return;
  const double time = columns[0].back(), window = columns[1].back();
  require(std::abs(time - checkpoint.time) < 0.5 * window,
          "row {} is at t = {:.9g} s, the checkpoint says {:.9g} s: results and checkpoint are of different "
          "runs; put those of one run together, or run the case again with another --out",
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
    // No frame lies within a window: half of one is more than any rounding.
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
  head.put(the_case.SerializeAsString());
  head.put(time);
  head.put(windows);
  head.put(frames);
  head.put(static_cast<std::uint64_t>(state.size()));  // as a string is put, but that it is not copied
  replace_file(folder / name, {head.take(), state});
}

Checkpoint Checkpoint::read(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / name;
  std::ifstream file(path, std::ios::binary);
  require(file.is_open(), "{}: no checkpoint there to resume from", path.string());
  std::ostringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  StateReader bytes(all);
  std::string found;
  std::string serialized;
  Checkpoint checkpoint;
  bytes.get(found);
  require(found == signature(), "{}: it is of another case or build, not of {}", path.string(), signature());
  bytes.get(serialized);
  bytes.get(checkpoint.time);
  bytes.get(checkpoint.windows);
  bytes.get(checkpoint.frames);
  bytes.get(checkpoint.state);
  bytes.finish();
  require(checkpoint.the_case.ParseFromString(serialized), "{}: its case cannot be read", path.string());
  return checkpoint;
}

void CheckpointWriter::write() {
  Checkpoint{.the_case = case_,
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
