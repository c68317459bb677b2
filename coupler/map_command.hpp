// cosurge map: where a case is stable, over a grid of its values.
#pragma once

#include <string>
#include <vector>

namespace cosurge {

/// Options of cosurge map.
struct MapOptions {
  std::string case_path;
  std::vector<std::string> overrides;
  /// "key.path=a,b,c": an axis; "key/key=a/b,c/d" changes several keys together; a vector is one value:
  /// "gravity=[0,-9.81],[0,-1.62]"
  std::vector<std::string> over;
  std::string out;   ///< the table, CSV; cells that it has already are not run again
  std::string note;  ///< command that makes it, the table's first line
  int cores = 0;     ///< runs at a time; 0: as many as the machine has
};

/// Runs every cell of the grid, each in a process of its own with one thread and without recorded results,
/// and writes a table row for each: the values of the keys, then
///   state          stable, growing or draining: Swing::judgement(); blown_up: it does not reach its end;
///                  refused: no such case
///   end            reached [s]
///   windows, iterations (a window), unconverged (windows)
///   ratio          largest estimate of the added-mass ratio
///   alternation    rms change of the load between windows in the last quarter of the run over that in the
///                  second
///   created        work that the scheme has created over all work that passed, without signs
///   frequency      of the first displacement probe's largest swing [Hz], by its passages through the mean
///   amplitude      half the range of it in the last half of the run [m]
///   peak           largest value of it in the run [m]
///   peak_time      [s]
///   seconds        processor time
///   reason         why the run did not end
/// Returns 0, or 1 if every cell was rejected or became unstable.
/// @throws Error for a wrong axis, and where the table cannot be written or is of another grid.
int map_command(const MapOptions& options);

}  // namespace cosurge
