#include "coupler/checkpoint.hpp"

#include <H5Cpp.h>

#include <fstream>
#include <sstream>

#include "common/error.hpp"
#include "common/state_bytes.hpp"
#include "common/version.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/result_file.hpp"

namespace cosurge {
namespace {

constexpr double rounding = 1e-9;  // s: rows of the checkpoint's own window are at its time, to the bit

constexpr int layout = 3;  // of states: to be raised whenever what is saved, or its order, changes

std::string signature() { return fmt::format("cosurge checkpoint {}, layout {}", version, layout); }

std::vector<double> column(const H5::H5File& file, const std::string& name) {
  const H5::DataSet dataset = file.openDataSet(name);
  std::vector<double> values(extent(dataset).front());
  if (!values.empty()) dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
  return values;
}

/// Frame `index` of one array.
Array frame_of(const H5::Group& group, const std::string& name, hsize_t index) {
  const H5::DataSet dataset = group.openDataSet(name);
  std::vector<hsize_t> size = extent(dataset);
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

Snapshot snapshot(const H5::H5File& file, const std::string& member, hsize_t index) {
  const H5::Group group = file.openGroup("/frames/" + member);
  Snapshot arrays;
  for (hsize_t k = 0; k < group.getNumObjs(); ++k)
    arrays.push_back(frame_of(group, group.getObjnameByIdx(k), index));
  return arrays;
}

void replay_file(const H5::H5File& file, double time, Recorder& recorder) {
  std::vector<std::vector<double>> columns;
  for (const History& history : recorder.histories())
    columns.push_back(column(file, "/history/" + history.name()));
  const std::vector<double> frame_times = column(file, "/frames/time");
  std::size_t row = 0;
  const auto rows_until = [&](double end) {
    for (; row < columns.front().size() && columns.front()[row] <= end + rounding; ++row) {
      std::vector<double> values;
      for (const auto& one : columns) values.push_back(one.at(row));
      recorder.row(values);
    }
  };
  for (std::size_t frame = 0; frame < frame_times.size() && frame_times[frame] <= time + rounding; ++frame) {
    rows_until(frame_times[frame]);
    std::vector<Snapshot> snapshots;
    for (const Member& member : recorder.members()) snapshots.push_back(snapshot(file, member.name, frame));
    recorder.frame(frame_times[frame], snapshots);
  }
  rows_until(time);
}

}  // namespace

void Checkpoint::write(const std::filesystem::path& folder) const {
  StateWriter head;
  head.put(signature());
  head.put(the_case.SerializeAsString());
  head.put(time);
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
  bytes.get(checkpoint.state);
  bytes.finish();
  require(checkpoint.the_case.ParseFromString(serialized), "{}: its case cannot be read", path.string());
  return checkpoint;
}

void CheckpointWriter::write() const {
  Checkpoint{.the_case = case_, .time = coupler_.time(), .state = coupler_.save()}.write(folder_);
}

void replay(const std::filesystem::path& results, double time, Recorder& recorder) {
  try {
    replay_file(H5::H5File(results.string(), H5F_ACC_RDONLY), time, recorder);
  } catch (const H5::Exception& exception) {  // not a std::exception
    throw Error(fmt::format("{}: cannot be read: {}", results.string(), exception.getDetailMsg()));
  }
}

}  // namespace cosurge
