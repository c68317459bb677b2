#include "common/serve.hpp"
#include "solid_solver/solid_participant.hpp"

int main(int argc, char** argv) {
  return cosurge::serve_main(argc, argv, [] { return std::make_unique<cosurge::SolidParticipant>(); });
}
