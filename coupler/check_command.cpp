#include "coupler/check_command.hpp"

#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "coupler/measured_size.hpp"
#include "coupler/report/case_picture.hpp"
#include "coupler/say.hpp"

namespace cosurge {

void check_command(const std::string& case_path, const std::vector<std::string>& overrides,
                   const std::string& picture) {
  if (!picture.empty()) require_picture_file(picture);
  const v1::Case the_case = load_case(case_path, overrides);
  for (const std::string& doubt : doubts(the_case)) say("warning: {}\n", doubt);
  say("{}: the case file is valid; setting up the solvers ...\n", the_case.title());
  Simulation simulation(the_case);
  simulation.begin();
  if (!picture.empty())
    write_case_picture(picture, the_case, {.fluid = simulation.fluid(), .solid = simulation.solid()});
  const MeasuredSize size = measure_size(simulation);
  say("{}: the case is valid\n", the_case.title());
  say_size(the_case, size);
}

}  // namespace cosurge
