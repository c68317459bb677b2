#include "coupler/simulation.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <sstream>
#include <thread>

#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "common/case/several_solids.hpp"
#include "common/error.hpp"
#include "common/solvers.hpp"
#include "common/wire/connection.hpp"
#include "coupler/coupler.hpp"
#include "coupler/launcher.hpp"
#include "coupler/program_path.hpp"
#include "coupler/run_folder.hpp"
#include "coupler/solid_group.hpp"

namespace cosurge {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds grace{2000};         // time in which solvers may end by themselves
constexpr milliseconds grace_at_once{200};  // the same, for a user who waits

std::string program_name(Role role) { return fmt::format("{}_solver", role_name(role)); }

int threads_of(Role role, int wanted) {
  if (role == Role::solid) return 1;  // its loops are too short for several threads
  return wanted > 0 ? wanted : static_cast<int>(std::thread::hardware_concurrency());
}

/// The participant for the fluid or a structure: an object in this thread, or a solver elsewhere.
struct Seat {
  std::string name;  // "fluid", "solid", or that of one of several structures
  std::unique_ptr<Participant> object;
  std::optional<Solver> solver;

  bool taken() const { return object != nullptr || solver; }
  Participant* participant() {
    if (object) return object.get();
    return solver ? &solver->participant() : nullptr;
  }
};

}  // namespace

class Simulation::Parts {
 public:
  explicit Parts(const v1::Case& the_case) : case_(the_case) {
    for (const std::string& name : solid_names(case_)) solids_.emplace_back().name = name;
  }

  /// The seat of a role and, if the case has several structures, of the structure of this name. @throws Error
  /// if the case has no such role, or it is taken.
  Seat& free_seat(Role role, const std::string& solid) {
    require(case_.has_fluid() || role != Role::fluid, "the case has no [fluid]: nobody can compute it");
    require(case_.has_solid() || role != Role::solid, "the case has no [solid]: nobody can compute it");
    require(role != Role::fluid || solid.empty(), "\"{}\" is the name of a structure, not of the fluid",
            solid);
    require(!coupler_, "the simulation has begun: who computes it cannot be chosen any more");
    Seat& seat = role == Role::fluid ? fluid_ : seat_of(solid);
    require(!seat.taken(), "the {} has a solver already", seat.name);
    return seat;
  }

  Seat& free_seat(const std::unique_ptr<Participant>& participant, const std::string& solid) {
    require(participant != nullptr, "there is no participant: the pointer is empty");
    const Identity identity = participant->identity();
    require(std::count(identity.dimensions.begin(), identity.dimensions.end(), case_.dimension()) > 0,
            "{} does not compute scenes of {} dimensions", identity.program, case_.dimension());
    return free_seat(participant->role(), solid);
  }

  /// The folder for the sockets of solvers elsewhere; created when it is first needed.
  const std::filesystem::path& sockets() { return (sockets_ ? *sockets_ : sockets_.emplace()).path(); }

  void begin() {
    if (coupler_) return;
    if (case_.has_fluid() && !fluid_.taken()) fluid_.object = make_fluid_solver();
    for (Seat& solid : solids_)
      if (!solid.taken()) solid.object = make_solid_solver();
    for (Seat* seat : seats())
      if (seat->solver)
        seat->solver->join(case_.dimension(), {"save", "frame"}, [this] { return cancelled(); });
    joined_ = true;
    coupler_ = std::make_unique<Coupler>(case_, Participants{.fluid = fluid(), .solid = solid()});
  }

  void end(const std::string& reason, bool at_once) {
    for (Seat* seat : seats())
      if (seat->solver) seat->solver->tell(reason);
    for (Seat* seat : seats()) {
      if (!seat->solver) continue;
      if (at_once)
        left_behind_ |= !seat->solver->kill(reason, grace_at_once);
      else
        seat->solver->stop(reason, grace);
    }
  }

  void fail(const std::string& name, SolverFault fault) {
    for (Seat* seat : seats())
      if (seat->name == name && seat->solver) return seat->solver->fail(fault);
    throw Error(
        fmt::format("\"{}\" is not a solver that computes elsewhere: it cannot be made to fail", name));
  }

  double exchange_seconds() {
    double sum = 0;
    for (Seat* seat : seats())
      if (seat->solver) sum += seat->solver->participant().cost().exchange();
    return sum;
  }

  Fluid* fluid() { return dynamic_cast<Fluid*>(fluid_.participant()); }

  /// All structures as one solid; null if the case has none, or a participant has not joined.
  Solid* solid() {
    if (solids_.empty()) return nullptr;
    if (solids_.size() == 1) return dynamic_cast<Solid*>(solids_.front().participant());
    if (!group_ && joined_) {
      std::vector<SolidGroup::Entry> entries;
      for (Seat& seat : solids_)
        entries.push_back({.name = seat.name, .solid = dynamic_cast<Solid*>(seat.participant())});
      group_.emplace(entries);
    }
    return group_ ? &*group_ : nullptr;
  }

  Coupler& coupler() {
    require(coupler_ != nullptr, "the simulation has not begun: call begin() first");
    return *coupler_;
  }

  const v1::Case& the_case() const { return case_; }
  bool left_behind() const { return left_behind_; }

  std::vector<Observer*> observers;
  std::function<bool()> before_start = [] { return false; };
  std::function<bool()> within_window = [] { return false; };

 private:
  /// The setup of the fluid, then those of the structures.
  std::vector<Seat*> seats() {
    std::vector<Seat*> all = {&fluid_};
    for (Seat& seat : solids_) all.push_back(&seat);
    return all;
  }

  Seat& seat_of(const std::string& solid) {
    const bool several = solids_.size() > 1;
    for (Seat& seat : solids_)
      if (several ? seat.name == solid : solid.empty()) return seat;
    require(several, "the case has one [solid]: it has no name, not \"{}\"", solid);
    throw Error(fmt::format("the case has several [[solid]]: name one of {}{}",
                            fmt::join(solid_names(case_), ", "),
                            solid.empty() ? "" : fmt::format(", not \"{}\"", solid)));
  }

  /// Called while a solver is waited for.
  bool cancelled() {
    if (joined_) return within_window();
    for (Seat* seat : seats())
      if (seat->solver) seat->solver->turn_away_strangers();
    return before_start();
  }

  v1::Case case_;
  std::optional<RunFolder> sockets_;
  Seat fluid_{.name = "fluid", .object = {}, .solver = {}};
  std::deque<Seat> solids_;
  std::optional<SolidGroup> group_;  // set if the case has several structures
  std::unique_ptr<Coupler> coupler_;
  bool joined_ = false;
  bool left_behind_ = false;
};

Simulation::Simulation(const v1::Case& the_case) : parts_(std::make_unique<Parts>(the_case)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

Simulation Simulation::of_file(const std::string& path, const std::vector<std::string>& overrides) {
  return Simulation(load_case(path, overrides));
}

Simulation Simulation::of_text(const std::string& toml, const std::vector<std::string>& overrides,
                               const std::filesystem::path& folder) {
  return Simulation(read_case(toml, overrides, folder));
}

void Simulation::here(std::unique_ptr<Participant> participant, const std::string& solid) {
  Seat& seat = parts_->free_seat(participant, solid);
  seat.object = std::move(participant);
}

void Simulation::in_thread(std::unique_ptr<Participant> participant, const Reach& reach) {
  Seat& seat = parts_->free_seat(participant, reach.solid);
  parts_->sockets();  // not needed here, but creating the folder removes those of runs that were killed
  const int threads = threads_of(participant->role(), reach.threads);
  seat.solver.emplace(Solver::thread(std::move(participant), reach.patience, threads, reach.solid));
}

void Simulation::in_process(Role role, const std::string& command, const Reach& reach) {
  Seat& seat = parts_->free_seat(role, reach.solid);
  const std::string name = program_name(role);
  const std::string log = reach.solid.empty() ? name : reach.solid + "_solver";
  std::istringstream text(command);
  std::vector<std::string> words(std::istream_iterator<std::string>(text), {});
  if (words.empty()) words.push_back(program_path(name).string());
  const Command start{.program = words.front(),
                      .arguments = {words.begin() + 1, words.end()},
                      .log = reach.log.empty() ? std::filesystem::path(log + ".log") : reach.log};
  const Wiring wiring{
      .folder = parts_->sockets(), .listen = "", .patience = reach.patience, .name = reach.solid};
  seat.solver.emplace(Solver::process(role, wiring, start, threads_of(role, reach.threads)));
}

std::string Simulation::by_hand(Role role, const std::string& listen, const Reach& reach) {
  Seat& seat = parts_->free_seat(role, reach.solid);
  const Wiring wiring{
      .folder = parts_->sockets(),
      .listen = listen,
      .patience = reach.patience,
      .allowed = reach.allow.empty() ? std::vector<AllowedMachine>{} : read_allowed_machines(reach.allow),
      .name = reach.solid};
  seat.solver.emplace(Solver::by_hand(role, wiring, program_path(program_name(role)).string()));
  return seat.solver->how_to_start();
}

void Simulation::give_up_when(std::function<bool()> before_start, std::function<bool()> within_window) {
  parts_->before_start = std::move(before_start);
  parts_->within_window = std::move(within_window);
}

void Simulation::observe(Observer& observer) { parts_->observers.push_back(&observer); }
void Simulation::begin() { parts_->begin(); }

bool Simulation::run(const std::function<bool()>& stop) {
  begin();
  return coupler().run(parts_->observers, stop);
}

std::string Simulation::save() { return coupler().save(); }

void Simulation::restore(const std::string& state, bool same_scheme) {
  begin();
  coupler().restore(state, same_scheme);
}

const v1::Case& Simulation::the_case() const { return parts_->the_case(); }
std::vector<std::string> Simulation::doubts() const { return cosurge::doubts(the_case()); }
const std::vector<Member>& Simulation::members() const { return parts_->coupler().members(); }
std::vector<Column> Simulation::columns() const { return parts_->coupler().columns(); }
double Simulation::time() const { return parts_->coupler().time(); }
Fluid* Simulation::fluid() { return parts_->fluid(); }
Solid* Simulation::solid() { return parts_->solid(); }
Coupler& Simulation::coupler() { return parts_->coupler(); }
void Simulation::fail(const std::string& solver, SolverFault fault) { parts_->fail(solver, fault); }
double Simulation::exchange_seconds() const { return parts_->exchange_seconds(); }
void Simulation::end(const std::string& reason, bool at_once) { parts_->end(reason, at_once); }
bool Simulation::left_behind() const { return parts_->left_behind(); }

}  // namespace cosurge
