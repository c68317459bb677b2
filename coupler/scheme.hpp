// How the participants advance together through one window.
#pragma once

#include <memory>

#include "coupler/interface_account.hpp"

namespace cosurge {

/// The participants of a run; either may be missing.
struct Participants {
  Participant* fluid = nullptr;
  Participant* solid = nullptr;
};

/// What the participants said of a window, those that are there: fluid first.
using Reports = std::vector<Report>;

class Scheme {
 public:
  virtual ~Scheme() = default;

  /// One window of all participants from the `surface` at its start to that at its end; `account` gets the
  /// load and the motion that stand in the end.
  virtual Reports advance(const Window& window, Surface& surface, InterfaceAccount& account) = 0;
};

std::unique_ptr<Scheme> make_scheme(const v1::Coupling& coupling, Participants participants);

}  // namespace cosurge
