#include "coupler/launcher.hpp"

#include <csignal>

#include "common/threads.hpp"
#include "common/wire/serve.hpp"

namespace cosurge {
namespace {

std::string name_of(Role role, const std::string& name) { return name.empty() ? role_name(role) : name; }

std::string solver_name(Role role, const std::string& name) {
  return fmt::format("the {} solver", name_of(role, name));
}

std::filesystem::path connection_file(Role role, const Wiring& wiring) {
  return wiring.folder / fmt::format("{}.connection", name_of(role, wiring.name));
}

}  // namespace

Solver::Solver(Role role, std::string token, Channel channel)
    : role_(role), token_(std::move(token)), channel_(std::make_unique<Channel>(std::move(channel))) {}

Solver::Solver(Solver&&) noexcept = default;

Solver Solver::waiting(Role role, const Wiring& wiring) {
  const std::string socket = fmt::format("ipc://{}/{}", wiring.folder.string(), name_of(role, wiring.name));
  Channel channel =
      Channel::listen(wiring.listen.empty() ? socket : wiring.listen, {.peer = solver_name(role, wiring.name),
                                                                       .patience = wiring.patience,
                                                                       .message_limit = wiring.message_limit,
                                                                       .allowed = wiring.allowed});
  const Connection connection{
      .role = role, .endpoint = channel.endpoint(), .token = new_token(), .server_key = channel.server_key()};
  write_connection(connection, connection_file(role, wiring));
  return {role, connection.token, std::move(channel)};
}

Solver Solver::process(Role role, const Wiring& wiring, Command command, int threads) {
  Solver solver = waiting(role, wiring);
  const std::vector<std::string> added = {"--connect", connection_file(role, wiring).string(), "--threads",
                                          std::to_string(threads)};
  command.arguments.insert(command.arguments.end(), added.begin(), added.end());
  solver.process_ = std::make_unique<SolverProcess>(command);
  return solver;
}

Solver Solver::by_hand(Role role, const Wiring& wiring, const std::string& program) {
  Solver solver = waiting(role, wiring);
  solver.how_to_start_ = fmt::format("{} --connect {}", program, connection_file(role, wiring).string());
  return solver;
}

Solver Solver::thread(std::unique_ptr<Participant> participant, double patience, int threads,
                      const std::string& name) {
  // As in a solver program: while one solver computes, the other waits.
  constexpr double patience_of_solver = 3600;
  const Role role = participant->role();
  const std::string token = new_token();
  auto [near, far] = Channel::pair({.peer = solver_name(role, name), .patience = patience},
                                   {.peer = "the coupler", .patience = patience_of_solver});
  Solver solver(role, token, std::move(near));
  std::promise<void> over;
  solver.thread_over_ = over.get_future();
  solver.thread_ = std::thread([served = std::move(participant), token, threads, wire = std::move(far),
                                end = std::move(over)]() mutable {
    set_threads(threads);
    try {
      serve(*served, wire, token);
    } catch (const std::exception&) {
      // The coupler has been told, or has ended the run.
    }
    end.set_value_at_thread_exit();
  });
  return solver;
}

Solver::~Solver() { stop("it has ended", std::chrono::milliseconds(500)); }

RemoteParticipant& Solver::join(int dimension, const std::vector<std::string>& capabilities,
                                Channel::Cancelled cancelled) {
  const auto ended = [process = process_.get()]() -> std::optional<std::string> {
    return process ? process->ended() : std::nullopt;
  };
  Channel channel = std::move(*channel_);
  channel_.reset();
  channel.set_cancelled(std::move(cancelled));
  const RemoteParticipant::Expectation expected{
      .role = role_, .token = token_, .dimension = dimension, .capabilities = capabilities};
  if (role_ == Role::fluid)
    participant_ = std::make_unique<RemoteFluid>(std::move(channel), expected, ended);
  else
    participant_ = std::make_unique<RemoteSolid>(std::move(channel), expected, ended);
  return *participant_;
}

void Solver::fail(SolverFault fault) {
  constexpr double late = 5;  // [s] longer than the wait for a peer without a sign of life
  if (fault == SolverFault::delay) return participant_->set_mishap({.delay = late, .damage = false});
  if (fault == SolverFault::corrupt) return participant_->set_mishap({.delay = 0, .damage = true});
  require(process_ != nullptr, "the {} solver is not a process that was started here", role_name(role_));
  ::kill(process_->pid(), fault == SolverFault::kill ? SIGKILL : SIGSTOP);
}

void Solver::tell(const std::string& reason) {
  if (participant_) participant_->abort(reason);
  channel_.reset();
}

bool Solver::stop(const std::string& reason, std::chrono::milliseconds grace) {
  tell(reason);
  if (thread_.joinable()) thread_.join();
  return process_ ? process_->stop(grace) : true;
}

bool Solver::kill(const std::string& reason, std::chrono::milliseconds grace) {
  tell(reason);
  if (process_) process_->kill(grace);
  if (!thread_.joinable()) return true;
  const bool over = thread_over_.wait_for(grace) == std::future_status::ready;
  over ? thread_.join() : thread_.detach();
  return over;
}

}  // namespace cosurge
