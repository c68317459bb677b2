#include "coupler/report/frame_source.hpp"

#include <algorithm>

#include "common/error.hpp"

namespace cosurge {
namespace {

std::string without_prefix(const std::string& name, const std::string& member) {
  return name.starts_with(member + "_") ? name.substr(member.size() + 1) : name;
}

std::vector<FrameArray> arrays_of(const Snapshot& snapshot, const std::string& member) {
  std::vector<FrameArray> arrays;
  for (const Array& array : snapshot)
    arrays.push_back({.name = without_prefix(array.name, member),
                      .unit = array.unit,
                      .frames = 1,
                      .particles = array.values.size() / static_cast<std::size_t>(array.components),
                      .components = array.components});
  return arrays;
}

}  // namespace

bool FrameSource::has(const std::string& array) const {
  return std::any_of(arrays_.begin(), arrays_.end(),
                     [&](const FrameArray& other) { return other.name == array; });
}

const FrameArray& FrameSource::find(const std::string& array) const {
  const auto found = std::find_if(arrays_.begin(), arrays_.end(),
                                  [&](const FrameArray& other) { return other.name == array; });
  require(found != arrays_.end(), "the frames have no array {}", array);
  return *found;
}

SnapshotFrames::SnapshotFrames(const Snapshot& snapshot, const std::string& member)
    : FrameSource(arrays_of(snapshot, member)), snapshot_(snapshot), member_(member) {}

std::vector<float> SnapshotFrames::values(const FrameArray& array, std::size_t) const {
  const auto found = std::find_if(snapshot_.begin(), snapshot_.end(), [&](const Array& other) {
    return without_prefix(other.name, member_) == array.name;
  });
  return found->values;
}

}  // namespace cosurge
