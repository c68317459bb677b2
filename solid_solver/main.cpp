#include "common/solvers.hpp"
#include "common/wire/serve_main.hpp"

int main(int argc, char** argv) { return cosurge::serve_main(argc, argv, cosurge::make_solid_solver); }
