#include "common/serve.hpp"
#include "fluid_solver/fluid_participant.hpp"

int main(int argc, char** argv) {
  return cosurge::serve_main(argc, argv, [] { return std::make_unique<cosurge::fluid::FluidParticipant>(); });
}
