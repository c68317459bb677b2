// Reads results.h5 and summary.json back.
#pragma once

#include <H5Cpp.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cosurge::testing {

/// Every dataset of a results file by path, as doubles.
using Datasets = std::map<std::string, std::vector<double>>;

inline void collect(const H5::Group& group, const std::string& path, Datasets& into) {
  for (hsize_t i = 0; i < group.getNumObjs(); ++i) {
    const std::string name = group.getObjnameByIdx(i);
    std::string child = path;
    child.append("/").append(name);
    if (group.getObjTypeByIdx(i) == H5G_GROUP) {
      collect(group.openGroup(name), child, into);
    } else {
      const H5::DataSet dataset = group.openDataSet(name);
      auto& values = into[child];
      values.resize(static_cast<std::size_t>(dataset.getSpace().getSimpleExtentNpoints()));
      if (!values.empty()) dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
    }
  }
}

inline Datasets read_results(const std::filesystem::path& folder) {
  const H5::H5File file((folder / "results.h5").string(), H5F_ACC_RDONLY);
  Datasets datasets;
  collect(file.openGroup("/"), "", datasets);
  return datasets;
}

/// Without values that depend on the clock.
inline Datasets physics(Datasets datasets) {
  std::erase_if(datasets, [](const auto& entry) { return entry.first.find("seconds") != std::string::npos; });
  return datasets;
}

inline nlohmann::json read_summary(const std::filesystem::path& folder) {
  return nlohmann::json::parse(std::ifstream(folder / "summary.json"));
}

}  // namespace cosurge::testing
