// Brings the solvers of a run to the coupler: as child processes, as threads, or started by hand.
#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/wire/remote_participant.hpp"
#include "coupler/solver_fault.hpp"
#include "coupler/solver_process.hpp"

namespace cosurge {

/// Address and settings of the connection to a solver.
struct Wiring {
  std::filesystem::path folder;  ///< gets NAME.connection and, unless `listen` says otherwise, the socket
  std::string listen;            ///< "tcp://address:port", or empty for a socket in the folder
  double patience = 600;         ///< longest wait for the solver's answer [s]
  std::size_t message_limit = Channel::Options{}.message_limit;  ///< [bytes]
  std::vector<AllowedMachine> allowed = {};  ///< machines that may connect, as in Channel::Options
  std::string name = {};  ///< name of the solver in messages and file names; default: its role
};

/// A solver that runs elsewhere. It is started at once, and welcomed by join(), so that several can start
/// together. The destructor ends what was started and waits for its end.
class Solver {
 public:
  /// Starts `command` as a child, with --connect and --threads added. `threads`: 0 leaves it to OpenMP.
  static Solver process(Role role, const Wiring& wiring, Command command, int threads);

  /// Runs a participant in a thread of this process. `name`: as in Wiring.
  static Solver thread(std::unique_ptr<Participant> participant, double patience, int threads,
                       const std::string& name = {});

  /// A solver that a person starts by the command how_to_start().
  static Solver by_hand(Role role, const Wiring& wiring, const std::string& program);

  Solver(Solver&&) noexcept;
  ~Solver();

  /// The command that starts the solver by hand.
  const std::string& how_to_start() const { return how_to_start_; }

  /// Must be called ten times a second while another solver is joined (Channel::turn_away_strangers).
  void turn_away_strangers() {
    if (channel_) channel_->turn_away_strangers();
  }

  /// Waits for the solver and welcomes it; gives up when `cancelled` returns true, as do all later calls.
  /// @throws as RemoteParticipant; Interrupted.
  RemoteParticipant& join(int dimension, const std::vector<std::string>& capabilities,
                          Channel::Cancelled cancelled = {});

  /// The connected solver, after join().
  RemoteParticipant& participant() { return *participant_; }
  const RemoteParticipant& participant() const { return *participant_; }

  /// Makes the solver fail, after join(). @throws Error if the fault needs a process that was started here.
  void fail(SolverFault fault);

  /// Tells the solver that the run is over, and why, if it has not ended. Does not wait.
  void tell(const std::string& reason);

  /// Ends the solver if it has not ended: tells it why, waits `grace`, then kills a process. Returns true if
  /// it ended without an error (always, for one started by hand).
  bool stop(const std::string& reason, std::chrono::milliseconds grace);

  /// Like stop(), but within a fraction of a second: a process that has not ended after `grace` is killed, a
  /// thread is left running. Returns false in the latter case: the program must then exit with _Exit.
  bool kill(const std::string& reason, std::chrono::milliseconds grace);

 private:
  Solver(Role role, std::string token, Channel channel);
  static Solver waiting(Role role, const Wiring& wiring);

  Role role_;
  std::string token_;
  std::string how_to_start_;
  std::unique_ptr<SolverProcess> process_;
  std::thread thread_;
  std::future<void> thread_over_;     // ready at the end of the thread
  std::unique_ptr<Channel> channel_;  // set until join()
  std::unique_ptr<RemoteParticipant> participant_;
};

}  // namespace cosurge
