#include "common/gate.hpp"

#include <linux/filter.h>
#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>

namespace cosurge {

namespace {

constexpr std::uint64_t most_of_a_handshake = 16384;  // [bytes]; CURVE's has 64 + 202 + 2000 at most

/// The local port of a TCP socket; 0 where it is none.
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
  strangers_.insert(connection);
  update();
}

void Gate::left(int connection) {
  connections_.erase(connection);
  strangers_.erase(connection);
  update();
}

/// ZeroMQ's thread may have closed one just now, and something else may have its number: hence the port.
void Gate::cut_off() const {
  if (descriptor_ < 0) return;
  for (const int connection : strangers_)
    if (port_of(connection) == port_of(descriptor_) && bytes_from(connection) > most_of_a_handshake)
      shutdown(connection, SHUT_RDWR);
}

void Gate::shut() {
  shut_ = true;
  update();
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
