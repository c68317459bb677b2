// Connections by programs that are not solvers to a TCP port that awaits a solver.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "common/wire/channel.hpp"
#include "common/wire/gate.hpp"
#include "proto/exchange.pb.h"
#include "tests/support/own_memory.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

v1::Request words(const std::string& reason) {
  v1::Request request;
  request.mutable_abort()->set_reason(reason);
  return request;
}

/// A TCP connection that knows no key.
class Stranger {
 public:
  /// Tries for `time`.
  Stranger(const Channel& channel, milliseconds time) {
    const std::string& endpoint = channel.endpoint();
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(endpoint.substr(endpoint.rfind(':') + 1))));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    socket_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    pollfd item{.fd = socket_, .events = POLLOUT, .revents = 0};
    connected_ = poll(&item, 1, static_cast<int>(time.count())) == 1 && (item.revents & POLLOUT) != 0;
  }
  Stranger(Stranger&& other) noexcept
      : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
  ~Stranger() {
    if (socket_ >= 0) close(socket_);
  }

  bool connected() const { return connected_; }

  /// Waits until the other side closes the connection.
  bool turned_away() const {
    pollfd item{.fd = socket_, .events = POLLRDHUP, .revents = 0};
    return poll(&item, 1, 2000) == 1;
  }

  /// Bytes that the other side's system takes; fewer than there are where it closes the connection.
  std::size_t send(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      pollfd item{.fd = socket_, .events = POLLOUT, .revents = 0};
      if (poll(&item, 1, 2000) != 1) break;
      const ssize_t taken = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (taken < 0) break;
      sent += static_cast<std::size_t>(taken);
    }
    return sent;
  }

 private:
  int socket_;
  bool connected_;
};

/// A connection that claims to have a key (ZMTP 3.0).
std::string curve_greeting() {
  return "\xff" + std::string(8, '\0') + "\x7f\x03" + std::string(1, '\0') + "CURVE" + std::string(15, '\0') +
         std::string(32, '\0');
}

Channel solver_of(const Channel& coupler) {
  return Channel::connect({.endpoint = coupler.endpoint(), .server_key = coupler.server_key()},
                          {.peer = "the coupler", .patience = 20});
}

TEST(Strangers, WhoseHandshakesFailDoNotStopTheOtherSolver) {
  const testing::ScratchFolder folder;
  const Channel knocked_at = Channel::listen("tcp://127.0.0.1:*", {.peer = "b"});  // not read by anyone
  Channel coupler =
      Channel::listen("ipc://" + (folder.path() / "wire").string(), {.peer = "a", .patience = 5});
  Channel solver = solver_of(coupler);
  bool turned_away = true;
  for (int k = 0; turned_away && k < 3000; ++k) {
    Stranger stranger(knocked_at, milliseconds(2000));
    stranger.send(std::string(80, 'x'));
    turned_away = stranger.turned_away();
  }
  v1::Request received;
  solver.send(words("still there"));
  coupler.receive(received, "a message");
  EXPECT_EQ(received.abort().reason(), "still there");
}

TEST(Strangers, WhoSayThatMuchComesAreCutOff) {
  const Channel coupler = Channel::listen("tcp://127.0.0.1:*", {.peer = "b", .message_limit = 1 << 20});
  Stranger stranger(coupler, milliseconds(2000));
  ASSERT_TRUE(stranger.connected());
  const std::string header = "\x06" + std::string(3, '\0') + "\x04" + std::string(4, '\0');  // 16 GiB follow
  ASSERT_EQ(stranger.send(curve_greeting()), curve_greeting().size());
  std::this_thread::sleep_for(milliseconds(200));
  const std::size_t most = std::size_t{100} << 20;
  EXPECT_LT(stranger.send(header + std::string(most, 'x')), std::size_t{32} << 20);
}

// Each within the limit of a message: together they would take all memory.
TEST(Strangers, WhoSendMuchWithoutAKeyAreCutOff) {
  Channel coupler = Channel::listen("tcp://127.0.0.1:*", {.peer = "b", .patience = 60});
  v1::Request received;
  std::thread waits([&] { coupler.receive(received, "a message"); });
  const std::string header = "\x06" + std::string(4, '\0') + "\x0f" + std::string(3, '\0');  // 240 MiB follow
  const std::size_t most = std::size_t{100} << 20;
  std::atomic<std::size_t> sent = 0;
  std::vector<std::thread> senders;
  for (int k = 0; k < 8; ++k)
    senders.emplace_back([&] {
      Stranger stranger(coupler, milliseconds(2000));
      stranger.send(curve_greeting());
      std::this_thread::sleep_for(milliseconds(200));
      sent += stranger.send(header + std::string(most, 'x'));
    });
  for (std::thread& sender : senders) sender.join();
  EXPECT_LT(sent, std::size_t{100} << 20);  // buffers of the system included
  Channel solver = solver_of(coupler);
  solver.send(words("I am one"));
  waits.join();
  EXPECT_EQ(received.abort().reason(), "I am one");
  // The solver itself may send as much as it likes.
  std::thread computes([&] {
    std::this_thread::sleep_for(milliseconds(300));
    for (int k = 0; k < 3; ++k) solver.send(words(std::string(std::size_t{1} << 22, 'y')));
  });
  for (int k = 0; k < 3; ++k) coupler.receive(received, "a large message");
  computes.join();
  EXPECT_EQ(received.abort().reason().size(), std::size_t{1} << 22);
}

TEST(Strangers, WhoSayNothingNeitherTakeAllFilesNorKeepTheSolverOut) {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  const rlimit few{.rlim_cur = 1024, .rlim_max = files.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);
  const std::size_t before = testing::open_files();
  Channel coupler = Channel::listen("tcp://127.0.0.1:*", {.peer = "b", .patience = 60});
  v1::Request received;
  std::thread waits([&] { coupler.receive(received, "a message"); });
  std::vector<Stranger> strangers;
  std::size_t connected = 0;
  for (int k = 0; k < 400; ++k) {
    strangers.emplace_back(coupler, milliseconds(k < 256 ? 2000 : 10));
    connected += strangers.back().connected();
    // The gate closes when the thread that waits has read of the connections: it needs its time on a busy
    // machine.
    if (k > 200) std::this_thread::sleep_for(milliseconds(2));
  }
  std::this_thread::sleep_for(milliseconds(200));
  EXPECT_GE(connected, Gate::most());
  // Their own ends are in this process, too; some may come while the gate closes.
  EXPECT_LE(testing::open_files() - before - strangers.size(), Gate::most() + 110);

  Channel solver = solver_of(coupler);
  solver.send(words("I am one"));
  waits.join();
  EXPECT_EQ(received.abort().reason(), "I am one");
  EXPECT_FALSE(Stranger(coupler, milliseconds(1500)).connected()) << "nobody else is awaited";
  coupler.send(words("welcome"));
  solver.receive(received, "a message");
  EXPECT_EQ(received.abort().reason(), "welcome");
  setrlimit(RLIMIT_NOFILE, &files);
}

TEST(Strangers, WhoWaitAreClosedOnceTheSolverHasCome) {
  Channel coupler = Channel::listen("tcp://127.0.0.1:*", {.peer = "b", .patience = 60});
  std::vector<Stranger> strangers;
  for (int k = 0; k < 50; ++k) strangers.emplace_back(coupler, milliseconds(2000));
  const auto begin = steady_clock::now();
  Channel solver = solver_of(coupler);
  solver.send(words("I am one"));
  v1::Request received;
  coupler.receive(received, "a message");
  coupler.send(words("welcome"));
  std::size_t turned_away = 0;
  for (const Stranger& stranger : strangers) turned_away += stranger.turned_away();
  EXPECT_EQ(turned_away, strangers.size());
  EXPECT_LT(steady_clock::now() - begin, milliseconds(2000)) << "after 3 s ZeroMQ closes them itself";
  solver.receive(received, "a message");
  EXPECT_EQ(received.abort().reason(), "welcome");
}

}  // namespace
}  // namespace cosurge
