#include "common/wire/gate.hpp"

#include <linux/filter.h>
#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>

namespace cosurge {

namespace {

// CURVE's handshake has 2.3 kB at most. A solver sends its Hello (64 KiB at most) and heartbeats after it.
constexpr std::uint64_t most_of_a_stranger = std::uint64_t{128} << 10;  // [bytes]
constexpr std::chrono::seconds time_of_handshake{5};  // after 3 s (line.cpp) ZeroMQ ends those without a key

/// The local port of a TCP socket; 0 if it is not a TCP socket.
in_port_t port_of(int descriptor) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return reinterpret_cast<const sockaddr_in&>(address).sin_port;
  if (address.ss_family == AF_INET6) return reinterpret_cast<const sockaddr_in6&>(address).sin6_port;
  return 0;
}

std::uint64_t bytes_from(int connection) {
  tcp_info info{};
  socklen_t size = sizeof info;
  return getsockopt(connection, IPPROTO_TCP, TCP_INFO, &info, &size) == 0 ? info.tcpi_bytes_received : 0;
}

}  // namespace

std::size_t Gate::most() {
  constexpr rlim_t enough = 256;
  rlimit files{};
  return getrlimit(RLIMIT_NOFILE, &files) == 0 ? std::min(files.rlim_cur / 4, enough) : enough;
}

void Gate::came(int connection) {
  connections_.insert(connection);
  strangers_[connection] = Clock::now();
  if (shut_) end(connection);  // it came just before
  update();
}

void Gate::left(int connection) {
  connections_.erase(connection);
  strangers_.erase(connection);
  update();
}

bool Gate::has_strangers() {
  std::erase_if(strangers_, [](const auto& one) { return Clock::now() - one.second > time_of_handshake; });
  return !strangers_.empty();
}

void Gate::cut_off() {
  if (descriptor_ < 0 || !has_strangers()) return;
  for (const auto& [connection, since] : strangers_)
    if (bytes_from(connection) > most_of_a_stranger) end(connection);
}

void Gate::shut(int peer) {
  strangers_.erase(peer);
  shut_ = true;
  update();
  for (const int connection : connections_)
    if (connection != peer) end(connection);
}

/// ZeroMQ's thread may have closed it just now, and something else may have its number: only the port tells.
void Gate::end(int connection) const {
  if (descriptor_ >= 0 && port_of(connection) == port_of(descriptor_)) shutdown(connection, SHUT_RDWR);
}

/// ZeroMQ cannot stop to listen without closing the connections that it has made. So the system is told to
/// drop what arrives at the listening socket; connections have sockets of their own.
void Gate::update() {
  const bool close = shut_ || connections_.size() >= most();
  if (close == closed_ || descriptor_ < 0) return;
  sock_filter drop = {.code = BPF_RET | BPF_K, .jt = 0, .jf = 0, .k = 0};  // keep 0 bytes
  const sock_fprog program = {.len = 1, .filter = &drop};
  const int done = close ? setsockopt(descriptor_, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program)
                         : setsockopt(descriptor_, SOL_SOCKET, SO_DETACH_FILTER, &program, sizeof program);
  if (done == 0) closed_ = close;
}

}  // namespace cosurge
