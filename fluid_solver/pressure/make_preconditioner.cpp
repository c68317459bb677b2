#include <stdexcept>

#include "fluid_solver/pressure/aggregation.hpp"
#include "fluid_solver/pressure/jacobi.hpp"

namespace cosurge::fluid {

std::unique_ptr<Preconditioner> make_preconditioner(PressureSolution::Preconditioner choice) {
  switch (choice) {
    case PressureSolution::Preconditioner::aggregation:
      return std::make_unique<Aggregation>();
    case PressureSolution::Preconditioner::jacobi:
      return std::make_unique<Jacobi>();
  }
  throw std::logic_error("unknown preconditioner");
}

}  // namespace cosurge::fluid
