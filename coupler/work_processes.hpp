// Pieces of work in processes of their own, some at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace cosurge {

/// Does `work(k)` for k = 0 ... count - 1, each in a child process, `most` at a time, and calls
/// `ended(k, fault)` here after each; `fault` says what ended a process that has not ended by itself, and is
/// empty otherwise. The children end with this process, however it ends.
/// @throws Error where there can be no process more.
void in_processes(std::size_t count, int most, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t, const std::string&)>& ended);

}  // namespace cosurge
