#include "coupler/report/case_picture.hpp"

#include "common/case/bodies.hpp"
#include "common/error.hpp"
#include "coupler/replace_file.hpp"
#include "coupler/report/case_table.hpp"
#include "coupler/report/outlines.hpp"
#include "coupler/report/page.hpp"
#include "coupler/report/run_document.hpp"
#include "coupler/say.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double megabytes = 20;  // one frame: all particles up to millions

Json start_of(const v1::Case& the_case, const Participants& participants) {
  const auto frames = [](Participant* participant, const std::string& member) {
    return SnapshotFrames(participant != nullptr ? participant->frame() : Snapshot(), member);
  };
  const SnapshotFrames fluid = frames(participants.fluid, "fluid"),
                       solid = frames(participants.solid, "solid");
  const SceneChoice choice = choose(the_case, fluid, solid, 1, megabytes);
  return {{"times", {0.0}},
          {"every_frame", choice.every_frame},
          {"every_particle", choice.every_particle},
          {"spacing",
           {{"fluid", the_case.fluid().spacing()},
            {"solid", the_case.has_solid() ? solid_spacing(the_case) : 0}}},
          {"outlines", outlines_of_check(the_case)},
          {"chunks", chunks(choice, fluid, solid, 0, 1)}};
}

}  // namespace

void require_picture_file(const fs::path& file) {
  require(file.extension() == ".html" || file.extension() == ".png",
          "--picture {}: the name must end in .png (a picture) or .html (a page for a browser)",
          file.string());
  require(!fs::exists(file), "--picture {}: exists already; choose another name", file.string());
  const fs::path folder = fs::absolute(file).parent_path();
  require(fs::is_directory(folder), "--picture {}: there is no folder {}", file.string(), folder.string());
}

void write_case_picture(const fs::path& file, const v1::Case& the_case, const Participants& participants) {
  const Json none = Json::array();
  Json run = {
      {"name", the_case.title()},
      {"title", the_case.title()},
      {"dimension", the_case.dimension()},
      {"status", {{"state", "not begun"}, {"time", 0.0}, {"end", the_case.time().end()}, {"windows", 0}}},
      {"facts", none},
      {"case", case_table(the_case)},
      {"tables", none},
      {"extremes", none},
      {"impulses", none},
      {"balance", none},
      {"phases", none},
      {"references", none},
      {"scene", start_of(the_case, participants)}};
  const std::string text = page(page_document("check", Json::array({std::move(run)})));
  replace_file(file, {text});
  say("  picture: {}\n", file.string());
}

}  // namespace cosurge
