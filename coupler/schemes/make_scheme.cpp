#include <stdexcept>

#include "coupler/schemes/auto.hpp"
#include "coupler/schemes/strong/strong.hpp"
#include "coupler/schemes/weak.hpp"
#include "coupler/schemes/weak_inertial.hpp"

namespace cosurge {

std::unique_ptr<Scheme> make_scheme(const v1::Coupling& coupling, Participants participants) {
  if (participants.fluid == nullptr || participants.solid == nullptr)
    return std::make_unique<Weak>(coupling, participants);
  switch (coupling.scheme()) {
    case v1::Coupling::weak:
      return std::make_unique<Weak>(coupling, participants);
    case v1::Coupling::strong:
    case v1::Coupling::strong_inertial:
      return std::make_unique<Strong>(coupling, participants);
    case v1::Coupling::weak_inertial:
      return std::make_unique<WeakInertial>(participants);
    case v1::Coupling::auto_:
      return std::make_unique<Auto>(coupling, participants);
  }
  throw std::logic_error("unknown coupling scheme");
}

}  // namespace cosurge
