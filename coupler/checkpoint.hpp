// The state from which a run can be resumed.
#pragma once

#include <filesystem>

#include "coupler/coupler.hpp"
#include "coupler/recorder.hpp"

namespace cosurge {

/// A run at one instant: the resolved case and the state of coupler and participants.
struct Checkpoint {
  static constexpr const char* name = "checkpoint";
  static constexpr const char* name_before = "checkpoint.old";  ///< name of the previous checkpoint

  /// A solver of the run; its state can be restored by the same program only.
  struct Solver {
    std::string name;  ///< "fluid" or "solid"
    std::string program;
    std::string version;
  };

  std::string build;  ///< build ID of the program that wrote it
  std::vector<Solver> solvers;
  v1::Case the_case;
  double time = 0;            ///< [s]
  std::uint64_t windows = 0;  ///< rows of each history at that time
  std::uint64_t frames = 0;   ///< frames at that time
  std::string state;          ///< Coupler::save()

  /// Replaces the checkpoint of `folder` atomically, and keeps the previous one. @throws Error if it cannot
  /// be written.
  void write(const std::filesystem::path& folder) const;

  /// The last checkpoint; if it is damaged, the previous one, with a warning. Also warns if it was written by
  /// another build of the same version.
  /// @throws Error when there is none, none is whole, or it is of another version of Cosurge.
  static Checkpoint read(const std::filesystem::path& folder);

  /// The content of one file. @throws Error if it is damaged or of another version.
  static Checkpoint read_file(const std::filesystem::path& path);

  /// @throws Error unless `members` are the programs whose states it contains.
  void require_same_programs(const std::vector<Member>& members) const;
};

/// Keeps a checkpoint of the last frame.
class CheckpointWriter : public Observer {
 public:
  CheckpointWriter(const std::filesystem::path& folder, const v1::Case& the_case, const Coupler& coupler)
      : folder_(folder), case_(the_case), coupler_(coupler) {}

  void window(const Window&, const Reports&, const std::vector<double>&) override {}
  void frame(double, const std::vector<Snapshot>&) override { write(); }
  void write();
  double time() const { return time_; }  ///< time of the last window [s]

 private:
  std::filesystem::path folder_;
  v1::Case case_;
  double time_ = 0;
  const Coupler& coupler_;
};

/// Feeds the rows and frames that `results` had at the time of `checkpoint` to a new recorder of the same
/// run.
/// @throws Error where the results lack a part of them, or are of another run.
void replay(const std::filesystem::path& results, const Checkpoint& checkpoint, Recorder& recorder);

}  // namespace cosurge
