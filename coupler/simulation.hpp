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

/// How a solver that computes elsewhere is reached.
struct Reach {
  double patience = 600;             ///< longest wait for an answer [s]
  int threads = 0;                   ///< of the solver; 0: one a core for a fluid, one for a solid
  std::filesystem::path log = {};    ///< what a program prints is added to it; default: NAME_solver.log
  std::filesystem::path allow = {};  ///< file with machines that may connect (docs/across_machines.md)
  std::string solid = {};            ///< name of the structure, where the case has several [[solid]]
};

/// First the participants are chosen, then begin() sets them up and run() goes through the windows. For a
/// role of the case that nobody was chosen for, Cosurge's own solver computes, called by this thread. All
/// ways give the same bits. Exceptions: Error where the user can mend it, NumericalError where the numbers
/// fail (common/faults.hpp), both of std::runtime_error.
class Simulation {
 public:
  /// Of a case that was checked.
  explicit Simulation(const v1::Case& the_case);

  /// Of a folder with a case.toml, or the file; `overrides` are "key.path=value".
  /// @throws Error with all errors of the case at once.
  static Simulation of_file(const std::string& path, const std::vector<std::string>& overrides = {});

  /// Of the text of a case file; files that it names lie in `folder`.
  static Simulation of_text(const std::string& toml, const std::vector<std::string>& overrides = {},
                            const std::filesystem::path& folder = ".");

  Simulation(Simulation&&) noexcept;
  ~Simulation();  ///< ends the solvers that compute elsewhere

  // Who takes part, each in its role: a Fluid or a Solid. All throw Error where the case has no such role, or
  // the role is taken.

  /// A participant of your own, called by this thread. `solid`: as in Reach.
  void here(std::unique_ptr<Participant> participant, const std::string& solid = {});

  /// A participant of your own that computes in a thread of its own, behind the same wire as a program.
  void in_thread(std::unique_ptr<Participant> participant, const Reach& reach = {});

  /// A program as a child process: Cosurge's own, or `command` with its arguments, parted by blanks; it gets
  /// --connect and --threads (serve_main() understands both). The program is ended with the thread that
  /// calls.
  void in_process(Role role, const std::string& command = "", const Reach& reach = {});

  /// A solver that somebody else starts: by the command that is returned, on this machine, or with `listen`
  /// = "tcp://*:5555" and `reach.allow` on another one.
  std::string by_hand(Role role, const std::string& listen = "", const Reach& reach = {});

  /// Questions that are asked ten times a second: whether to give up the wait for solvers to join, and
  /// whether to give up a window that they compute. The call that waits then throws Interrupted.
  void give_up_when(std::function<bool()> before_start, std::function<bool()> within_window);

  /// Told of every window and frame from then on; must outlive the run.
  void observe(Observer& observer);

  /// Welcomes the solvers and sets them up. Without effect after the first time.
  void begin();

  /// All windows until the end of the case, or until `stop` says true; begins where that has not been done.
  /// Returns whether the end was reached; a later call goes on.
  bool run(const std::function<bool()>& stop = [] { return false; });

  /// The state of the whole run between two windows, for a simulation of the same case, participants and
  /// build: it goes on bit for bit. `same_scheme`: see Coupler::restore().
  std::string save();
  void restore(const std::string& state, bool same_scheme = true);

  const v1::Case& the_case() const;
  std::vector<std::string> doubts() const;  ///< what the case allows, but hardly means

  // Once it has begun.
  const std::vector<Member>& members() const;  ///< fluid first; what stands in the columns of reports
  std::vector<Column> columns() const;         ///< of the coupler's own values
  double time() const;                         ///< reached [s]
  Fluid* fluid();                              ///< null where the case has none
  Solid* solid();                              ///< null where the case has none; several structures as one
  Coupler& coupler();

  /// Lets the solver of this name fail: "fluid", "solid", or that of one of several structures. Once it has
  /// begun. @throws Error where no such solver computes elsewhere, or its process is not a child of this one.
  void fail(const std::string& solver, SolverFault fault);

  /// Seconds that messages have cost beyond what the solvers computed.
  double exchange_seconds() const;

  /// Ends the solvers that have not ended and tells them why; all hear of it before any is waited for.
  /// `at_once`: in a fraction of a second, whatever they do.
  void end(const std::string& reason, bool at_once = false);

  /// Whether a thread of this process still computes after end() at once: the program must then end without a
  /// look back (std::_Exit).
  bool left_behind() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cosurge
