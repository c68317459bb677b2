// Cases that are made to take all memory or time, and numbers that no double holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/geometry/crossing_sides.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;
using ::testing::AllOf;
using testing::CaseText;
using ::testing::EndsWith;
using testing::errors_of;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double soon = 10;  // s: a second is enough on an idle machine

double seconds_since(steady_clock::time_point start) {
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

/// A key of so many parts.
std::string long_key(std::size_t parts) {
  std::string key = "a";
  for (std::size_t k = 1; k < parts; ++k) key += ".a";
  return key;
}

/// Errors in a file with this text.
std::string errors_in(const std::string& text) {
  const testing::ScratchFolder folder;
  const fs::path file = folder.path() / "case.toml";
  std::ofstream(file) << text;
  return errors_of(file.string());
}

TEST(CaseBombs, KeysOfVeryManyPartsAreRefused) {
  const auto refused = HasSubstr("a key has more than 16 parts");
  EXPECT_THAT(errors_in("\n\n" + long_key(400000) + " = 1\n"), AllOf(refused, HasSubstr("case.toml:3:")));
  EXPECT_THAT(errors_in("[" + long_key(400000) + "]\n"), refused);
  EXPECT_THAT(errors_in("x = { " + long_key(400000) + " = 1 }\n"), refused);
  EXPECT_THAT(errors_in("x = \"a # \\\" \" # \"\n" + long_key(17) + " = 1\n"), refused);
  EXPECT_THAT(errors_of(CaseText().file(), {long_key(60000) + "=1"}), refused);
  EXPECT_THAT(errors_of(CaseText().file(), {"fluid.density={" + long_key(60000) + "=1}"}), refused);
}

TEST(CaseBombs, LettersBeyondAsciiAreForQuotesAndCommentsOnly) {
  const auto refused =
      HasSubstr("a letter or blank that is not ASCII, which is allowed in quotes and comments only");
  EXPECT_THAT(errors_in("# \u00fc\nx = 0.\u0262\n"), AllOf(refused, HasSubstr("case.toml:2:")));
  EXPECT_THAT(errors_in("\u00e4 = 1\n"), refused);
  EXPECT_THAT(errors_in("title = \"\u00fc\"\n# \u00fc\n"), Not(refused));
  EXPECT_EQ(errors_of(CaseText().file(), {"title=Gr\u00f6\u00dfe"}), "");
}

TEST(CaseBombs, DotsElsewhereAreNoParts) {
  const std::string dots(100, '.');
  EXPECT_THAT(errors_in("title = \"" + dots + "\" # " + dots + "\nreference = '''\n" + dots + "'''\n"),
              Not(HasSubstr("parts")));
}

TEST(CaseBombs, AFileThatIsTooLargeIsNotRead) {
  const auto start = steady_clock::now();
  std::string text;
  for (int k = 0; k < 1000000; ++k) text += "k" + std::to_string(k) + " = 1\n";
  EXPECT_THAT(errors_in(text), HasSubstr("the limit for a case is 1 MB"));
  EXPECT_LT(seconds_since(start), soon);
}

TEST(CaseBombs, OfVeryManyErrorsAHundredAreShownAndTheOthersCounted) {
  std::string text;
  for (int k = 0; k < 50000; ++k) text += "k" + std::to_string(k) + " = 1\n";
  const std::string errors = errors_in(text);
  EXPECT_THAT(errors, AllOf(HasSubstr("case.toml:1: k0: unknown key"), Not(HasSubstr("k150:"))));
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 100);
  EXPECT_THAT(errors, EndsWith("and 49903 more errors"));  // three keys are missing
}

TEST(CaseBombs, ALoopOfLinksIsNoCase) {
  const testing::ScratchFolder folder;
  fs::create_symlink("b", folder.path() / "a");
  fs::create_symlink("a", folder.path() / "b");
  EXPECT_THAT(errors_of((folder.path() / "a").string()), HasSubstr("no such case: Too many levels"));
}

std::vector<Facet<2>> closed(const std::vector<Vec<2>>& corners) {
  std::vector<Facet<2>> sides;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sides.push_back({corners[k], corners[(k + 1) % corners.size()]});
  return sides;
}

TEST(CaseBombs, PolygonsOfVeryManyCornersAreCheckedSoon) {
  constexpr int count = 300000;
  constexpr double pi = 3.14159265358979323846;
  std::vector<Vec<2>> circle;
  for (int k = 0; k < count; ++k)
    circle.emplace_back(std::cos(2 * pi * k / count), std::sin(2 * pi * k / count));
  auto start = steady_clock::now();
  EXPECT_EQ(crossing_sides(closed(circle)), "");
  EXPECT_LT(seconds_since(start), soon);
  std::swap(circle[1000], circle[1001]);
  start = steady_clock::now();
  EXPECT_THAT(crossing_sides(closed(circle)),
              HasSubstr("crosses itself: the sides from corners 999 and 1001"));
  EXPECT_LT(seconds_since(start), soon);
  // Teeth of a comb, which all reach over each other in both directions.
  std::vector<Vec<2>> comb;
  for (int k = 0; k < count; ++k)
    comb.emplace_back(k + (k % 2 == 0 ? 0 : count), k + (k % 2 == 0 ? 0 : count));
  start = steady_clock::now();
  EXPECT_THAT(crossing_sides(closed(comb)), HasSubstr("too many to check for crossings"));
  EXPECT_LT(seconds_since(start), soon);
}

TEST(WholeNumbers, ThatNoDoubleHoldsAreRefusedInFilesAndOnTheCommandLine) {
  for (const char* number : {"9007199254740993", "9223372036854775807", "-9007199254740993"}) {
    const auto refused =
        HasSubstr(std::string(number) + " is a whole number that a double cannot store exactly");
    EXPECT_THAT(errors_of(CaseText().file(), {std::string("fluid.density=") + number}), refused);
  }
  EXPECT_THAT(errors_of(CaseText("end    = 0.1", "end    = 9007199254740993").file()),
              AllOf(HasSubstr("time.end: 9007199254740993 is a whole number"), HasSubstr("case.toml:")));
  EXPECT_EQ(load_case(CaseText().file(), {"fluid.density=9007199254740994"}).fluid().density(),
            9007199254740994.0);
  EXPECT_EQ(load_case(CaseText().file(), {"fluid.density=9007199254740993.0"}).fluid().density(),
            9007199254740992.0);
  EXPECT_THAT(errors_of(CaseText().file(), {"fluid.pressure.max_iterations=9007199254740993"}),
              HasSubstr("must be <= 2147483647"));
}

}  // namespace
}  // namespace cosurge
