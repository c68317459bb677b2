#include "common/serve_main.hpp"
#include "common/solvers.hpp"

int main(int argc, char** argv) { return cosurge::serve_main(argc, argv, cosurge::make_fluid_solver); }
