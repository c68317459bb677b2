// Where a report takes the frames of a solver from: the results of a run, or a solver that has not run yet.
#pragma once

#include <string>
#include <vector>

#include "common/participant.hpp"
#include "coupler/results.hpp"

namespace cosurge {

/// The arrays of one solver's frames, by name. All calls throw Error if there is no such array.
class FrameSource {
 public:
  explicit FrameSource(std::vector<FrameArray> arrays) : arrays_(std::move(arrays)) {}
  virtual ~FrameSource() = default;

  bool has(const std::string& array) const;
  std::string unit(const std::string& array) const { return find(array).unit; }
  int components(const std::string& array) const { return find(array).components; }
  std::size_t particles() const { return arrays_.empty() ? 0 : arrays_.front().particles; }

  /// Components values for each particle, one particle after the other.
  std::vector<float> read(const std::string& array, std::size_t frame) const {
    return values(find(array), frame);
  }

 private:
  const FrameArray& find(const std::string& array) const;
  virtual std::vector<float> values(const FrameArray& array, std::size_t frame) const = 0;

  std::vector<FrameArray> arrays_;
};

/// The frames in the results of a run, which must live as long.
class RecordedFrames : public FrameSource {
 public:
  RecordedFrames(const Results& results, const std::string& member)
      : FrameSource(results.arrays(member)), results_(results), member_(member) {}

 private:
  std::vector<float> values(const FrameArray& array, std::size_t frame) const override {
    return results_.frame(member_, array, frame);
  }

  const Results& results_;
  std::string member_;
};

/// A solver's state at one instant, as its only frame. `member`: its name, with which array names may begin.
class SnapshotFrames : public FrameSource {
 public:
  SnapshotFrames(const Snapshot& snapshot, const std::string& member);

 private:
  std::vector<float> values(const FrameArray& array, std::size_t frame) const override;

  Snapshot snapshot_;
  std::string member_;
};

}  // namespace cosurge
