// Runs pieces of work in separate processes, several at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace cosurge {

/// Runs `work(k)` for k = 0 ... count - 1, each in a child process, `most` at a time, and calls `ended(k,
/// fault)` in this process after each. `fault` is the reason why a process was ended by a signal, and is
/// empty otherwise. The children end with this process, however it ends.
/// @throws Error if no more processes can be created.
void in_processes(std::size_t count, int most, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& ended);

}  // namespace cosurge
