#include "coupler/fault.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

#include "common/error.hpp"
#include "coupler/say.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

struct Kind {
  const char* name;
  SolverFault fault;
  const char* words;  // what happens to the solver
};

constexpr std::array<Kind, 4> kinds = {{{"kill", SolverFault::kill, "is killed"},
                                        {"freeze", SolverFault::freeze, "is frozen"},
                                        {"delay", SolverFault::delay, "answers 5 s late"},
                                        {"corrupt", SolverFault::corrupt, "sends a corrupt message"}}};

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// One fault. @throws Error
Fault fault_of(const std::string& text, const std::vector<std::string>& solvers, double end,
               const std::vector<std::string>& elsewhere) {
  const std::size_t colon = text.find(':'), at = text.rfind('@');
  require(colon != std::string::npos && at != std::string::npos && colon < at,
          "--fault {}: must be KIND:SOLVER@TIME, for instance kill:{}@0.05", text, solvers.back());
  const std::string name = text.substr(0, colon), solver = text.substr(colon + 1, at - colon - 1);
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) { return name == one.name; });
  require(kind != kinds.end(), "--fault {}: \"{}\" must be kill, freeze, delay or corrupt", text, name);
  require(contains(solvers, solver), "--fault {}: \"{}\" must be one of {}", text, solver,
          fmt::join(solvers, ", "));
  const std::optional<double> time = number_of(text.substr(at + 1));
  require(time && *time >= 0 && *time < end, "--fault {}: the time must be >= 0 and < time.end = {} [s]",
          text, end);
  const bool of_process = kind->fault == SolverFault::kill || kind->fault == SolverFault::freeze;
  require(!of_process || !contains(elsewhere, solver),
          "--fault {}: the {} solver is not a process that this run starts; leave out --in-process and "
          "--by-hand {}, or choose delay or corrupt",
          text, solver, solver);
  return {.kind = kind->fault, .solver = solver, .time = *time};
}

}  // namespace

std::vector<Fault> faults_of(const std::vector<std::string>& texts, const std::vector<std::string>& solvers,
                             double end, const std::vector<std::string>& elsewhere) {
  std::vector<Fault> faults;
  std::vector<std::string> errors;
  for (const std::string& text : texts) {
    try {
      faults.push_back(fault_of(text, solvers, end, elsewhere));
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  require(errors.empty(), "{}", fmt::join(errors, "\n"));
  return faults;
}

void let_fail(std::vector<Fault>& faults, Simulation& simulation) {
  std::erase_if(faults, [&](const Fault& fault) {
    if (simulation.time() < fault.time) return false;
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) { return fault.kind == one.fault; });
    say("t = {:.6g} s: --fault: the {} solver {}\n", simulation.time(), fault.solver, kind->words);
    simulation.fail(fault.solver, fault.kind);
    return true;
  });
}

}  // namespace cosurge
