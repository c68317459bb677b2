#include "common/gate.hpp"

#include <linux/filter.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>

namespace cosurge {

std::size_t Gate::most() {
  constexpr rlim_t enough = 256;
  rlimit files{};
  return getrlimit(RLIMIT_NOFILE, &files) == 0 ? std::min(files.rlim_cur / 4, enough) : enough;
}

void Gate::came(int connection) {
  connections_.insert(connection);
  update();
}

void Gate::left(int connection) {
  connections_.erase(connection);
  update();
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
