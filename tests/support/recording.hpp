// Runs a case within the test and keeps its histories and frames.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "coupler/simulation.hpp"
#include "proto/case.pb.h"

namespace cosurge::testing {

class Recording : public Observer {
 public:
  /// Runs `the_case` to its end.
  explicit Recording(const v1::Case& the_case) {
    Simulation simulation(the_case);
    simulation.begin();
    members_ = simulation.members();
    coupling_ = simulation.columns();
    simulation.observe(*this);
    simulation.run();
  }

  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override {
    time_.push_back(window.start + window.size);
    for (std::size_t m = 0; m < reports.size(); ++m)
      for (std::size_t c = 0; c < reports[m].values.size(); ++c)
        columns_[members_[m].name + "/" + members_[m].setup.columns[c].name].push_back(reports[m].values[c]);
    for (std::size_t c = 0; c < coupling.size(); ++c)
      columns_["coupling/" + coupling_[c].name].push_back(coupling[c]);
  }

  void frame(double time, const std::vector<Snapshot>& snapshots) override {
    frames_.emplace_back(time, snapshots);
  }

  const std::vector<double>& time() const { return time_; }
  /// "fluid/front", "solid/tip_x", "coupling/work_points", ...
  const std::vector<double>& column(const std::string& name) const { return columns_.at(name); }
  const std::vector<std::pair<double, std::vector<Snapshot>>>& frames() const { return frames_; }

 private:
  std::vector<Member> members_;
  std::vector<Column> coupling_;
  std::vector<double> time_;
  std::map<std::string, std::vector<double>> columns_;
  std::vector<std::pair<double, std::vector<Snapshot>>> frames_;
};

/// The array of a snapshot by name.
inline const std::vector<float>& array(const Snapshot& snapshot, const std::string& name) {
  for (const Array& one : snapshot)
    if (one.name == name) return one.values;
  throw std::out_of_range(name);
}

}  // namespace cosurge::testing
