// A water column without particles as a solver program.
#include "common/wire/serve_main.hpp"
#include "tests/support/mock_participant.hpp"

int main(int argc, char** argv) {
  return cosurge::serve_main(argc, argv, [] { return cosurge::testing::water_column({}); });
}
