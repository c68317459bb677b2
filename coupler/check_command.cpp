#include "coupler/check_command.hpp"

#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "coupler/draw/case_drawing.hpp"
#include "coupler/measured_size.hpp"
#include "coupler/report/case_picture.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

/// A page or a PNG, by the name of the file.
void draw(const std::filesystem::path& file, Simulation& simulation) {
  const v1::Case& the_case = simulation.the_case();
  if (file.extension() == ".html")
    return write_case_picture(file, the_case, {.fluid = simulation.fluid(), .solid = simulation.solid()});
  const auto frames = [](Participant* participant, const std::string& member) {
    return SnapshotFrames(participant == nullptr ? Snapshot() : participant->frame(), member);
  };
  draw_case(file, the_case, frames(simulation.fluid(), "fluid"), frames(simulation.solid(), "solid"));
  say("  picture: {}\n", file.string());
}

}  // namespace

void check_command(const std::string& case_path, const std::vector<std::string>& overrides,
                   const std::string& picture) {
  if (!picture.empty()) require_picture_file(picture);
  const v1::Case the_case = load_case(case_path, overrides);
  for (const std::string& doubt : doubts(the_case)) say("warning: {}\n", doubt);
  say("{}: the case file is valid; setting up the solvers ...\n", the_case.title());
  Simulation simulation(the_case);
  simulation.begin();
  if (!picture.empty()) draw(picture, simulation);
  const MeasuredSize size = measure_size(simulation);
  say("{}: the case is valid\n", the_case.title());
  say_size(the_case, size);
}

}  // namespace cosurge
