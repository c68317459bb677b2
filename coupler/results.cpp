#include "coupler/results.hpp"

#include <google/protobuf/util/json_util.h>

#include <chrono>
#include <thread>

#include "common/error.hpp"
#include "coupler/recorder.hpp"
#include "coupler/result_file.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;

std::string unit_of(const H5::DataSet& dataset) {
  return dataset.attrExists("unit") ? text_of(dataset.openAttribute("unit")) : "";
}

std::vector<double> all_rows(const H5::DataSet& series) {
  const std::vector<hsize_t> size = extent(series);
  return first_rows(series, size.empty() ? 0 : size[0]);
}

/// The histories in a group, and in the groups in it.
void add_names(const H5::Group& group, const std::string& place, std::vector<std::string>& names) {
  for (hsize_t k = 0; k < group.getNumObjs(); ++k) {
    const std::string name = group.getObjnameByIdx(k), whole = place + "/" + name;
    if (group.childObjType(name) == H5O_TYPE_GROUP)
      add_names(group.openGroup(name), whole, names);
    else
      names.push_back(whole);
  }
}

}  // namespace

template <typename Action>
auto Results::attempt(const std::string& doing, Action action) const {
  try {
    return action();
  } catch (const H5::Exception& error) {  // not a std::exception
    throw Error(fmt::format("{}: {}: {}", path_.string(), doing, error.getDetailMsg()));
  }
}

fs::path Results::file_at(const fs::path& place) {
  const fs::path file = fs::is_directory(place) ? place / Recorder::results_name : place;
  require(fs::is_regular_file(file), "{}: contains no results", file.string());
  return file;
}

Results::Results(const fs::path& place) : path_(file_at(place)) {
  H5::Exception::dontPrint();
  H5::FileAccPropList access;
  H5Pset_file_locking(access.getId(), false, true);  // the run may go on
  attempt("cannot be read as results: it is not an HDF5 file, or is damaged", [&] {
    results_ = H5::H5File(path_.string(), H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, access);
    int format = 0;
    if (results_.attrExists("format"))
      results_.openAttribute("format").read(H5::PredType::NATIVE_INT, &format);
    require(format <= Recorder::format,
            "{}: has format {}, written by a later version of Cosurge; this version reads formats up to {}",
            path_.string(), format, Recorder::format);
  });
}

std::string Results::attribute(const std::string& name) const {
  return attempt("cannot read attribute " + name, [&] {
    return results_.attrExists(name) ? text_of(results_.openAttribute(name)) : std::string();
  });
}

v1::Case Results::the_case() const {
  google::protobuf::util::JsonParseOptions options;
  options.ignore_unknown_fields = true;  // written by another version
  v1::Case the_case;
  const auto status = google::protobuf::util::JsonStringToMessage(attribute("case"), &the_case, options);
  require(status.ok(), "{}: the case in it cannot be read: {}", path_.string(), status.ToString());
  return the_case;
}

std::vector<std::string> Results::histories() const {
  return attempt("has no histories", [&] {
    const H5::Group root = results_.openGroup("/history");
    std::vector<std::string> names = {"time", "window"};
    for (hsize_t k = 0; k < root.getNumObjs(); ++k) {
      const std::string group = root.getObjnameByIdx(k);
      if (root.childObjType(group) == H5O_TYPE_GROUP) add_names(root.openGroup(group), group, names);
    }
    return names;
  });
}

Series Results::history(const std::string& name) const {
  return attempt("cannot read the history " + name, [&] {
    const H5::DataSet dataset = results_.openDataSet("/history/" + name);
    return Series{.name = name, .unit = unit_of(dataset), .values = all_rows(dataset)};
  });
}

std::vector<double> Results::frame_times() const {
  return attempt("cannot read the times of the frames",
                 [&] { return all_rows(results_.openDataSet("/frames/time")); });
}

std::vector<FrameArray> Results::arrays(const std::string& member) const {
  return attempt("cannot read the frames of the " + member, [&] {
    std::vector<FrameArray> arrays;
    const H5::Group frames = results_.openGroup("/frames");
    if (!frames.nameExists(member)) return arrays;
    const H5::Group group = frames.openGroup(member);
    for (hsize_t k = 0; k < group.getNumObjs(); ++k) {
      const std::string name = group.getObjnameByIdx(k);
      const H5::DataSet dataset = group.openDataSet(name);
      const std::vector<hsize_t> size = extent(dataset);
      require(size.size() == 2 || size.size() == 3, "{}: {} has {} dimensions: it is not an array of Cosurge",
              path_.string(), dataset.getObjName(), size.size());
      arrays.push_back({.name = name,
                        .unit = unit_of(dataset),
                        .frames = size[0],
                        .particles = size[1],
                        .components = size.size() > 2 ? static_cast<int>(size[2]) : 1});
    }
    return arrays;
  });
}

std::vector<float> Results::frame(const std::string& member, const FrameArray& array, std::size_t k) const {
  return attempt(fmt::format("cannot read frame {} of the {}'s {}", k, member, array.name), [&] {
    const H5::DataSet dataset = results_.openDataSet("/frames/" + member + "/" + array.name);
    std::vector<hsize_t> size = extent(dataset);
    std::vector<hsize_t> start(size.size(), 0);
    start[0] = k;
    size[0] = 1;
    const H5::DataSpace file = dataset.getSpace();
    file.selectHyperslab(H5S_SELECT_SET, size.data(), start.data());
    std::vector<float> values(array.particles * static_cast<std::size_t>(array.components));
    dataset.read(values.data(), H5::PredType::NATIVE_FLOAT,
                 H5::DataSpace(static_cast<int>(size.size()), size.data()), file);
    return values;
  });
}

void read_patiently(const std::function<void()>& read) {
  constexpr int attempts = 20;
  constexpr std::chrono::milliseconds pause{100};
  for (int attempt = 1; attempt < attempts; ++attempt) {
    try {
      return read();
    } catch (const Error&) {
      std::this_thread::sleep_for(pause);
    }
  }
  read();
}

}  // namespace cosurge
