// A run in one object: a case, the participants that compute it, the observers that look on.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupler/observer.hpp"
#include "coupler/solver_fault.hpp"

namespace cosurge {

class Coupler;

/// Settings for a solver that computes in another thread, process or machine.
struct Reach {
  double patience = 600;  ///< longest wait for an answer [s]
  int threads = 0;        ///< threads of the solver; 0: one per core for a fluid, one for a solid
  std::filesystem::path log =
      {};  ///< file to which the output of a program is appended; default: NAME_solver.log
  std::filesystem::path allow = {};  ///< file with machines that may connect (docs/across_machines.md)
  std::string solid = {};            ///< name of the structure, if the case has several [[solid]]
};

/// A coupled run. First the participants are chosen, then begin() sets them up and run() computes the
/// windows. If no participant is chosen for a role of the case, Cosurge's own solver computes it in the
/// calling thread. All ways give bit-identical results. Exceptions (common/faults.hpp), derived from
/// std::runtime_error: Error for faults that the user can correct, NumericalError if the computation fails.
class Simulation {
 public:
  /// A run of a checked case.
  explicit Simulation(const v1::Case& the_case);

  /// A run of a case in a folder (with a case.toml) or file; `overrides` are "key.path=value".
  /// @throws Error with all errors of the case at once.
  static Simulation of_file(const std::string& path, const std::vector<std::string>& overrides = {});

  /// A run of a case given as the text of a case file; files that it names lie in `folder`.
  static Simulation of_text(const std::string& toml, const std::vector<std::string>& overrides = {},
                            const std::filesystem::path& folder = ".");

  Simulation(Simulation&&) noexcept;
  ~Simulation();  ///< ends the solvers that compute elsewhere

  // Choice of the participants: a Fluid or a Solid for each role. All functions throw Error if the case has
  // no such role, or the role is taken.

  /// A participant of your own, called by this thread. `solid`: as in Reach.
  void here(std::unique_ptr<Participant> participant, const std::string& solid = {});

  /// A participant of your own that computes in a separate thread and exchanges messages as a program does.
  void in_thread(std::unique_ptr<Participant> participant, const Reach& reach = {});

  /// A program as a child process: Cosurge's own, or `command` with arguments separated by blanks, to which
  /// --connect and --threads are added (serve_main() understands both). The program is killed when the thread
  /// that calls this function ends.
  void in_process(Role role, const std::string& command = "", const Reach& reach = {});

  /// A solver that somebody else starts with the returned command: on this machine or, with `listen` =
  /// "tcp://*:5555" and `reach.allow`, on another one.
  std::string by_hand(Role role, const std::string& listen = "", const Reach& reach = {});

  /// Sets two functions that are called ten times a second: whether to stop waiting for solvers to join, and
  /// whether to abandon a window that they compute. The waiting call then throws Interrupted.
  void give_up_when(std::function<bool()> before_start, std::function<bool()> within_window);

  /// Adds an observer of every later window and frame; it must outlive the run.
  void observe(Observer& observer);

  /// Connects to the solvers and initializes all participants. Has no effect after the first call.
  void begin();

  /// Computes windows until the end of the case, or until `stop` returns true; calls begin() if necessary.
  /// Returns whether the end was reached; a later call continues.
  bool run(const std::function<bool()>& stop = [] { return false; });

  /// The state of the whole run between two windows. A simulation with the same case, participants and build
  /// that restores it continues with bit-identical results. `same_scheme`: see Coupler::restore().
  std::string save();
  void restore(const std::string& state, bool same_scheme = true);

  const v1::Case& the_case() const;
  std::vector<std::string> doubts()
      const;  ///< warnings about values of the case that are allowed but probably not intended

  // After begin():
  const std::vector<Member>& members() const;  ///< fluid first; their setups have the columns of reports
  std::vector<Column> columns() const;         ///< columns of the coupler's own values
  double time() const;                         ///< reached [s]
  Fluid* fluid();                              ///< null where the case has none
  Solid* solid();                              ///< null where the case has none; several structures as one
  Coupler& coupler();

  /// Makes a solver fail, after begin(). `solver`: "fluid", "solid", or the name of one of several
  /// structures. @throws Error if this solver does not compute elsewhere, or if its process is not a child of
  /// this one.
  void fail(const std::string& solver, SolverFault fault);

  /// Wall time of the exchange of messages, without the time in which the solvers computed [s].
  double exchange_seconds() const;

  /// Tells all solvers that have not ended that the run is over and why, then waits for them. `at_once`:
  /// kills those that have not ended within a fraction of a second.
  void end(const std::string& reason, bool at_once = false);

  /// Whether a thread of this process still computes after end() with `at_once`: the program must then exit
  /// with std::_Exit.
  bool left_behind() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cosurge
