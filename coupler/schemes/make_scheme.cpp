#include <stdexcept>

#include "coupler/schemes/weak.hpp"

namespace cosurge {

std::unique_ptr<Scheme> make_scheme(const v1::Coupling& coupling, Participants participants) {
  switch (coupling.scheme()) {
    case v1::Coupling::weak:
      return std::make_unique<Weak>(participants);
  }
  throw std::logic_error("unknown coupling scheme");
}

}  // namespace cosurge
