#include <stdexcept>

#include "fluid_solver/pressure/aggregation.hpp"
#include "fluid_solver/pressure/jacobi.hpp"

namespace cosurge::fluid {

std::unique_ptr<Preconditioner> make_preconditioner(const v1::Pressure& choice) {
  switch (choice.preconditioner()) {
    case v1::Pressure::aggregation:
      return std::make_unique<Aggregation>();
    case v1::Pressure::jacobi:
      return std::make_unique<Jacobi>();
  }
  throw std::logic_error("unknown preconditioner");
}

}  // namespace cosurge::fluid
