#include <stdexcept>

#include "coupler/schemes/strong/aitken.hpp"
#include "coupler/schemes/strong/constant.hpp"
#include "coupler/schemes/strong/iqn_ils.hpp"

namespace cosurge {

std::unique_ptr<Relaxation> make_relaxation(const v1::Iteration& iteration) {
  switch (iteration.relaxation()) {
    case v1::Iteration::constant:
      return std::make_unique<Constant>(iteration.factor());
    case v1::Iteration::aitken:
      return std::make_unique<Aitken>(iteration.factor());
    case v1::Iteration::iqn_ils:
      return std::make_unique<IqnIls>(iteration.factor(), iteration.reuse());
  }
  throw std::logic_error("unknown relaxation");
}

}  // namespace cosurge
