// Pictures of cases and videos of runs, by the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cosurge_program.hpp"
#include "tests/support/program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double patience = 300;  // s: a few are enough on an idle machine

class Pictures : public ::testing::Test {
 protected:
  /// Runs a line of the shell and returns what it said.
  std::string said(const std::string& line, int status = 0) const {
    Program program({"/bin/bash", "-c", line}, scratch_.path() / "log");
    EXPECT_EQ(program.wait(patience), status) << program.output();
    return program.output();
  }

  std::string in_folder(const std::string& name) const { return (scratch_.path() / name).string(); }

  /// A run of some frames, made once.
  std::string run() const {
    const std::string folder = in_folder("run");
    said(fmt::format("{} run {} --quiet --set time.end=0.1 --out {}", cosurge_program, small_dam_break,
                     folder));
    return folder;
  }

  static std::string bytes(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
};

TEST_F(Pictures, OfACaseAreDrawnWithoutABrowserAndNothingIsWrittenOver) {
  const std::string line =
      fmt::format("{} check {} --picture {}", cosurge_program, small_dam_break, in_folder("case.png"));
  EXPECT_THAT(said(line), HasSubstr("picture: " + in_folder("case.png")));
  const std::string before = bytes(in_folder("case.png"));
  EXPECT_THAT(before, StartsWith("\x89PNG"));
  EXPECT_GT(before.size(), 10000U);
  EXPECT_THAT(said(line, 1), HasSubstr("exists already"));
  EXPECT_EQ(bytes(in_folder("case.png")), before);
  EXPECT_THAT(
      said(fmt::format("{} check {} --picture {}", cosurge_program, small_dam_break, in_folder("case.jpg")),
           1),
      HasSubstr("must end in .png (a picture) or .html"));
}

TEST_F(Pictures, OfARunBecomeAVideoWithAllFrames) {
  if (std::system("command -v ffprobe >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const std::string folder = run(), video = in_folder("run.mp4");
  const std::string line = fmt::format("{} report {} --video {}", cosurge_program, folder, video);
  EXPECT_THAT(said(line), AllOf(HasSubstr("video: " + video), HasSubstr("6 frames of the results")));
  const std::string found =
      said("ffprobe -v error -show_entries stream=codec_name,width,height,duration -of csv=p=0 " + video);
  EXPECT_THAT(found, StartsWith("h264,1280,"));
  EXPECT_NEAR(std::stod(found.substr(found.rfind(',') + 1)), 6 / 4.0, 0.1);
  EXPECT_FALSE(fs::exists(folder + "/report.html")) << "no page beside the video";
  EXPECT_FALSE(fs::exists(video + ".part"));
  EXPECT_FALSE(fs::exists(video + ".log"));
  EXPECT_THAT(said(line, 1), HasSubstr("exists already"));
}

TEST_F(Pictures, OfARunNeedFfmpegAndSayItsPackage) {
  const std::string folder = run();
  const std::string told = said(
      fmt::format("PATH=/nowhere {} report {} --video {}", cosurge_program, folder, in_folder("run.avi")), 1);
  EXPECT_THAT(told, AllOf(HasSubstr("apt install ffmpeg"), HasSubstr("must end in .mp4")));
  EXPECT_FALSE(fs::exists(in_folder("run.avi")));
  EXPECT_THAT(said(fmt::format("{} report {} --video v.mp4 --size 3", cosurge_program, folder), 2),
              HasSubstr("excludes"));
}

}  // namespace
}  // namespace cosurge::testing
