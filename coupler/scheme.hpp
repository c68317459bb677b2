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
  int iterations = 1;     ///< times that the fluid went through it
  double residual = 0;    ///< relative error of the velocity that the water saw
  std::string note;       ///< decision of the scheme after the window, with its reason; usually empty
  bool converged = true;  ///< false: a scheme that iterates has given up; the nearest iteration counts
  bool settled = true;    ///< false: it may turn out later that the window has to be gone through again
  bool again = false;     ///< all windows since the last settled one must be repeated with the new choice
};

/// The effort of one exchange, in which the water saw the velocity `seen` and the structure answered
/// `answered`.
inline Effort one_exchange(const Field& seen, const Field& answered) {
  const double norm = answered.norm();
  return {.iterations = 1, .residual = norm > 0 ? (answered - seen).norm() / norm : 0, .note = {}};
}

class Scheme {
 public:
  virtual ~Scheme() = default;

  /// One window of all participants, with the `interface` at its start and then at its end; `account` gets
  /// the load and the motion that stand in the end.
  virtual Reports advance(const Window& window, InterfaceState& interface, InterfaceAccount& account) = 0;

  virtual const Effort& effort() const = 0;
  virtual bool may_go_back() const { return false; }  ///< whether there may be windows that are not settled
  virtual const AddedMassRatio& ratio() const = 0;

  /// The scheme's state between windows; after restore() results are bit-identical.
  virtual void save(StateWriter& state) const = 0;
  virtual void restore(InterfaceReader& state) = 0;
};

std::unique_ptr<Scheme> make_scheme(const v1::Coupling& coupling, Participants participants);

}  // namespace cosurge
