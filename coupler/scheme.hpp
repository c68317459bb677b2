// How the participants advance together through one window.
#pragma once

#include <memory>

#include "coupler/added_mass_ratio.hpp"
#include "coupler/interface_account.hpp"
#include "coupler/observer.hpp"
#include "proto/case.pb.h"

namespace cosurge {

/// The participants of a run; either may be missing.
struct Participants {
  Fluid* fluid = nullptr;
  Solid* solid = nullptr;
};

/// Report of a scheme on the last window.
struct Effort {
  int iterations = 1;     ///< number of computations of the window by the fluid
  double residual = 0;    ///< relative error of the velocity that the water used
  std::string note;       ///< decision of the scheme after the window, with its reason; usually empty
  bool converged = true;  ///< false: limit reached; the iterate with the least residual is used
  bool settled = true;    ///< false: the window may have to be repeated later
  bool again = false;     ///< all windows since the last settled one must be repeated with the new choice
};

/// The effort of one exchange, in which the water used the velocity `seen` and the structure responded with
/// `answered`.
inline Effort one_exchange(const Field& seen, const Field& answered) {
  const double norm = answered.norm();
  return {.iterations = 1, .residual = norm > 0 ? (answered - seen).norm() / norm : 0, .note = {}};
}

/// A coupling scheme: how motion and load are exchanged in a window.
class Scheme {
 public:
  virtual ~Scheme() = default;

  /// Computes one window with all participants. `interface` holds the motion and load at its start, and
  /// afterwards at its end; `account` gets the final load and motion.
  virtual Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) = 0;

  virtual const Effort& effort() const = 0;
  /// Whether windows may be repeated later, so that effort().settled can be false.
  virtual bool may_go_back() const { return false; }
  virtual const AddedMassRatio& ratio() const = 0;

  /// The scheme's state between windows; after restore() results are bit-identical.
  virtual void save(StateWriter& state) const = 0;
  virtual void restore(InterfaceReader& state) = 0;
};

/// Creates the scheme of `coupling.scheme`.
std::unique_ptr<Scheme> make_scheme(const v1::Coupling& coupling, Participants participants);

}  // namespace cosurge
