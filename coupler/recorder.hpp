// Records a run: results.h5, and results.xdmf beside it for ParaView.
//
//   /history/time, /history/window      end and length of each window [s]
//   /history/fluid/COLUMN, /history/solid/COLUMN, /history/coupling/COLUMN      one value a window
//   /frames/time                        instants of the frames [s]
//   /frames/fluid/ARRAY, /frames/solid/ARRAY      frames x particles (x components, for vectors)
//   /mesh/fluid, /mesh/solid            cells between particles: the numbers of their corners, a row a cell
//   /interface/position, area, body     the interface points in the reference configuration
//
// Every dataset of numbers with a unit says it in the attribute `unit`. Attributes of the root: format,
// cosurge (version), title, case (JSON, with all defaults), date (UTC), fluid and solid (program and
// version), case_file (where it was), set (values in place of its own), changes (by resumptions).
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "coupler/coupler.hpp"
#include "coupler/history.hpp"
#include "coupler/provenance.hpp"
#include "coupler/result_file.hpp"
#include "coupler/xdmf.hpp"

namespace cosurge {

/// Writes the results of a run while it goes on, in the layout above.
class Recorder : public Observer {
 public:
  static constexpr int format = 1;  ///< version of results.h5; raised when old readers would fail
  static constexpr const char* results_name = "results.h5";
  static constexpr const char* xdmf_name = "results.xdmf";

  /// Creates the files in `folder`, which exists. @throws Error when they cannot be written or exist already.
  /// `name`: name of the HDF5 file.
  Recorder(const std::filesystem::path& folder, const v1::Case& the_case, const std::vector<Member>& members,
           const Interface& interface, const std::vector<Column>& coupling_columns,
           const Provenance& provenance = {}, const std::string& name = results_name);

  /// One row of the histories. Rows stay in memory until the next frame() or flush().
  void window(const Window& window, const Reports& reports, const std::vector<double>& coupling) override;

  /// The same with one value a history, in their order.
  void row(const std::vector<double>& values);

  /// Records one frame, in the order of the members. Afterwards everything recorded is on the disk, except
  /// the XDMF file: its length grows with the number of frames and it is written as a whole, so it is written
  /// only as often as a fiftieth of the time allows, and at flush(). The member's name at the front of an
  /// array's name is removed: "solid_position" becomes /frames/solid/position. The structure gets an
  /// additional array with its displacement since the first frame.
  void frame(double time, const std::vector<Snapshot>& sent) override;

  void flush();

  /// Renames the HDF5 file, and replaces an existing one.
  void move(const std::filesystem::path& results) { file_.move(results); }

  // Values for the summary.
  const v1::Case& the_case() const { return case_; }
  const std::vector<Member>& members() const { return members_; }
  /// The history of this name, such as "fluid/front"; null if there is none.
  const History* history(const std::string& name) const;
  const std::vector<History>& histories() const { return histories_; }
  std::uint64_t windows() const { return windows_; }
  double time() const { return time_; }  ///< reached [s]
  double wall_seconds() const;           ///< since the recorder was made

 private:
  void describe(const Provenance& provenance);
  void write_waiting();
  void write_xdmf();
  void write_mesh(XdmfCloud& cloud, const Snapshot& first);
  Snapshot with_displacement(const Snapshot& solid);

  using Clock = std::chrono::steady_clock;

  std::filesystem::path folder_;
  v1::Case case_;
  std::vector<Member> members_;
  ResultFile file_;
  std::vector<History> histories_;  // in the order of the rows: time, window, reports, coupling values
  std::vector<double> frame_times_;
  std::vector<XdmfCloud> clouds_;
  std::vector<float> undeformed_;  // positions of the structure in the first frame
  Clock::time_point xdmf_end_;     // end of the last writing
  Clock::duration xdmf_cost_{};    // duration of the last writing
  bool xdmf_waits_ = false;
  std::uint64_t windows_ = 0;
  double time_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace cosurge
