// The loop over the windows of a run.
#pragma once

#include <functional>
#include <optional>

#include "coupler/observer.hpp"
#include "coupler/scheme.hpp"
#include "coupler/window_schedule.hpp"

namespace cosurge {

/// Runs a case with any participants.
class Coupler {
 public:
  /// Initializes the participants, the fluid first: its points are the interface.
  Coupler(const v1::Case& the_case, Participants participants);

  /// Computes all windows from the present state until the end, or until `stop` returns true. Returns whether
  /// the end was reached. A scheme may repeat windows, back to the last settled one or to the last frame; a
  /// stopped run goes back to the same state.
  /// @throws exceptions of the participants; observers have seen all windows before.
  bool run(const std::vector<Observer*>& observers, const std::function<bool()>& stop);

  /// The state of the whole run between two windows, participants included. A new Coupler of the same case
  /// that restores it continues with bit-identical results. If the scheme differs from that of the saved
  /// state (`same_scheme` false), the scheme starts anew.
  std::string save() const;
  void restore(const std::string& state, bool same_scheme = true);

  const std::vector<Member>& members() const { return members_; }
  const Interface& interface() const { return interface_; }
  /// Columns that the coupler itself reports for a window.
  std::vector<Column> columns() const;
  const std::vector<std::string>& notes() const { return notes_; }  ///< decisions of the scheme
  const InterfaceAccount& account() const { return account_; }
  std::uint64_t unconverged() const { return unconverged_; }  ///< number of windows that did not converge
  double time() const { return schedule_.time(); }
  std::uint64_t windows() const { return schedule_.windows(); }
  std::uint64_t frames() const { return schedule_.frames(); }  ///< shown once run() has begun

 private:
  /// A window that observers have not seen yet.
  struct Row {
    Window window;
    Reports reports;
    std::vector<double> values;
  };
  using Observers = std::vector<Observer*>;

  void pass(const Window& window);
  void settle(const Observers& observers);
  void go_back();
  void tell(const Observers& observers);
  std::vector<double> values() const;
  void show_frame(const Observers& observers);
  std::vector<Participant*> all() const;
  void take_in(const std::string& name, const Participant& participant, const Setup& setup);
  void save_all_but_scheme(StateWriter& state) const;
  void restore_all_but_scheme(InterfaceReader& state);
  InterfaceReader reader(const std::string& state) const;  ///< the string must outlive it

  v1::Case case_;
  Participants participants_;
  std::vector<Member> members_;
  Interface interface_;
  InterfaceState state_;
  WindowSchedule schedule_;
  std::unique_ptr<Scheme> scheme_;
  InterfaceAccount account_;
  std::uint64_t unconverged_ = 0;
  std::vector<std::string> notes_;  // decisions of the scheme since this coupler was made
  bool began_ = false;              // the frame at the start has been shown
  double largest_ = 0;              // largest next window that all participants accept [s]
  std::vector<Row> waiting_;        // windows that are not settled
  std::string settled_;             // state before the waiting windows, without the scheme's; may be empty
  std::string settled_scheme_;
};

}  // namespace cosurge
