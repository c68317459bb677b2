#include "common/case/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/error.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using testing::CaseText;
using ::testing::ElementsAre;
using testing::errors_of;
using ::testing::HasSubstr;

const std::vector<TableColumn> three = {{"time", "s"}, {"x", "m"}, {"angle", "rad"}};

/// The numbers read from a file with these bytes, or the error message.
struct Outcome {
  std::vector<double> values;
  std::string error;
};

Outcome outcome_of(const std::string& bytes, const std::vector<TableColumn>& columns = three) {
  const testing::ScratchFolder folder;
  std::ofstream(folder.path() / "t.csv", std::ios::binary) << bytes;
  try {
    return {read_table(folder.path() / "t.csv", columns).values, ""};
  } catch (const Error& error) {
    const std::string what = error.what();
    return {{}, what.substr(what.find("t.csv"))};
  }
}

struct Form {
  std::string name;
  std::string bytes;
};

/// The rows (0, 0, 0) and (1.5, 0.25, -0.125) in many forms.
const Form forms[] = {
    {"Commas", "0,0,0\n1.5,0.25,-0.125\n"},
    {"CommasAndBlanks", "0, 0, 0\n1.5,  0.25, -0.125\n"},
    {"CommasAndTabs", "0,\t0,\t0\n1.5,\t0.25,\t-0.125\n"},
    {"Blanks", "0 0 0\n  1.5  0.25 -0.125  \n"},
    {"Tabs", "0\t0\t0\n1.5\t0.25\t-0.125\n"},
    {"Semicolons", "0;0;0\n1.5;0.25;-0.125\n"},
    {"SemicolonsAndDecimalCommas", "0;0;0\n1,5;0,25;-0,125\n"},
    {"SemicolonsAndThreeDigits", "0,000;0,000;0,000\n1,500;0,250;-0,125\n"},
    {"QuotedDecimalCommas", "\"0\",\"0\",\"0\"\n\"1,5\",\"0,25\",\"-0,125\"\n"},
    {"QuotedNumbers", "\"0\",\"0\",\"0\"\n\"1.5\",\"0.25\",\"-0.125\"\n"},
    {"ByteOrderMark",
     "\xEF\xBB\xBF"
     "0,0,0\n1.5,0.25,-0.125\n"},
    {"WindowsLines", "0,0,0\r\n1.5,0.25,-0.125\r\n"},
    {"OldMacintoshLines", "0,0,0\r1.5,0.25,-0.125\r"},
    {"EmptyLines", "\n0,0,0\n\n   \n1.5,0.25,-0.125\n\n"},
    {"EmptyWindowsLines",
     "\xEF\xBB\xBF"
     "0,0,0\r\n\r\n1.5,0.25,-0.125\r\n\r\n"},
    {"RowsOfEmptyCells", "0,0,0\n,,\n1.5,0.25,-0.125\n,,,\n;;;\n"},
    {"EmptyCellsAtTheEnd", "0,0,0,\n1.5,0.25,-0.125,,\n"},
    {"NoEndOfTheLastLine", "0,0,0\n1.5,0.25,-0.125"},
    {"Comments", "# rest\n0,0,0\n  # then a stroke\n1.5,0.25,-0.125 # there\n"},
    {"ALineForTheSpreadsheet", "sep=;\n0;0;0\n1,5;0,25;-0,125\n"},
    {"Header", "time,x,angle\n0,0,0\n1.5,0.25,-0.125\n"},
    {"HeaderWithUnits", "t [s], x [m], angle [rad]\n0,0,0\n1.5,0.25,-0.125\n"},
    {"HeaderInCapitals", "Time (s);X (m);Angle (rad)\n0;0;0\n1,5;0,25;-0,125\n"},
    {"HeaderAndALineOfUnits", "time,x,angle\ns,m,rad\n0,0,0\n1.5,0.25,-0.125\n"},
    {"HeaderInAnotherOrder", "x [m],angle [rad],time [s]\n0,0,0\n0.25,-0.125,1.5\n"},
    {"HeaderInAnotherLanguage", "Zeit;Weg;Winkel\n0;0;0\n1,5;0,25;-0,125\n"},
    {"QuotedHeader", "\"time\",\"x\",\"angle\"\n0,0,0\n1.5,0.25,-0.125\n"},
    {"Exponents", "0e0,0E+00,0.0\n1.5E+00,25e-2,-1.25E-01\n"},
    {"Signs", "+0,-0,0\n+1.5,+0.25,-0.125\n"},
    {"BlanksByTheMillion", "0,0,0\n1.5,0.25,-0.125" + std::string(1000000, ' ') + "\n"},
    {"DigitsByTheThousand", "0,0,0\n1.5,0.25" + std::string(100000, '0') + ",-0.125\n"},
    {"LinesEndTwice", "0,0,0\r\r\n1.5,0.25,-0.125\r\r\n"},
    {"HeaderInLatin1", "Zeit;Weg;Dreh\xFCng\n0;0;0\n1,5;0,25;-0,125\n"},
    {"HeaderBehindASign", "% time x angle\n0 0 0\n1.5 0.25 -0.125\n"},
    {"NumbersWithoutALeadingZero", "0,0,0\n1.5,.25,-.125\n"},
};

class TableForms : public ::testing::TestWithParam<Form> {};

TEST_P(TableForms, IsReadAsTheSpreadsheetMeantIt) {
  const Outcome outcome = outcome_of(GetParam().bytes);
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(outcome.values, ElementsAre(0, 0, 0, 1.5, 0.25, -0.125));
}

INSTANTIATE_TEST_SUITE_P(Table, TableForms, ::testing::ValuesIn(forms),
                         [](const auto& form) { return form.param.name; });

struct BadForm {
  std::string name;
  std::string bytes;
  std::string error;
};

const std::string numbers = "must be 3 numbers: time [s], x [m], angle [rad]";

const BadForm bad_forms[] = {
    {"DecimalCommasAndTabs", "0,000\t0,000\t0,0\n1,500\t0,250\t0,1\n",
     "t.csv:1: " + numbers + "; \"0,000\" has a comma, but tabs separate the numbers"},
    {"DecimalCommasAndTwoTabbedColumns", "0\t0\t0\n1,500\t0,250\n",
     "t.csv:2: " + numbers + "; \"1,500\" has a comma"},
    {"DecimalCommasAndBlanks", "0,0 0,0 0,0\n", "t.csv:1: " + numbers},
    {"DecimalCommasAndCommas", "0,000,0,000,0,000\n",
     "t.csv:1: " + numbers + "; \"000\" looks like the end of"},
    {"DecimalCommasOfOneDigit", "0,0,0,0,0,0\n1,5,0,2,0,1\n",
     "this line has 6 (separate numbers with decimal commas by"},
    {"ThousandsOrDecimals", "1,500;2,250;3,125\n",
     "t.csv:1: \"1,500\" can mean 1.500 or 1500; write numbers with a decimal point"},
    {"ThousandsAndDecimals", "0;0;0\n1.234,5;0;0\n", "t.csv:2: " + numbers + "; \"1.234,5\" is not a number"},
    {"TooFew", "0,0,0\n\n1,0\n", "t.csv:3: " + numbers + "; this line has 2"},
    {"TooMany", "0,0,0,0\n", "t.csv:1: " + numbers + "; this line has 4"},
    {"AMissingCell", "0,,0\n", "t.csv:1: " + numbers + "; one is missing"},
    {"AWord", "0,0,0\n1,n/a,0\n", "t.csv:2: " + numbers + "; \"n/a\" is not a number"},
    {"AnErrorOfTheSpreadsheet", "0,0,0\n1,#DIV/0!,0\n", "t.csv:2: " + numbers},
    {"Infinity", "0,0,0\n1,inf,0\n", "t.csv:2: " + numbers + "; inf is not finite"},
    {"Nan", "0,nan,0\n", "t.csv:1: " + numbers + "; nan is not finite"},
    {"TooLarge", "0,1e999,0\n", "t.csv:1: " + numbers + "; 1e999 is not finite"},
    {"AVeryLongWord", "0,0,0\n" + std::string(100000, 'x') + ",0,0\n",
     "t.csv:2: " + numbers + "; \"" + std::string(40, 'x') + "...\" is not a number"},
    {"AMillionCells",
     "0,0,0\n" +
         [] {
           std::string many;
           for (int k = 0; k < 1000000; ++k) many += "1,";
           return many;
         }() +
         "\n",
     "t.csv:2: " + numbers + "; this line has 1000000"},
    {"AMinusOfTypography",
     "0,0,0\n1,\xE2\x88\x92"
     "0.05,0\n",
     "t.csv:2: " + numbers},
    {"ABlankThatDoesNotBreak",
     "0,0,0\n1,\xC2\xA0"
     "0.05,0\n",
     "t.csv:2: " + numbers},
    {"ExponentOfFortran", "0,0,0\n1,5.0D-02,0\n", "\"5.0D-02\" is not a number"},
    {"Hexadecimal", "0,0,0\n1,0x1,0\n", "\"0x1\" is not a number"},
    {"TimesOfDay", "00:00:01,0,0\n", "\"00:00:01\" is not a number"},
    {"ANumberOfRows", "2\n0 0 0\n1 0 0\n", "t.csv:1: " + numbers + "; this line has 1"},
    {"ASecondHeader", "time,x,angle\n0,0,0\ntime,x,angle\n1,0,0\n", "t.csv:3: " + numbers},
    {"AQuoteThatDoesNotEnd", "0,0,0\n1,\"0.05,0\n", "t.csv:2: " + numbers},
    {"Bars", "0|0|0\n", "\"0|0|0\" is not a number"},
    {"OtherTimes", "t [ms],x [m],angle [rad]\n0,0,0\n", "t.csv:1: time is in ms, must be in s"},
    {"TwoPoints", "0,1.2.3,0\n", "\"1.2.3\" is not a number"},
    {"AUnitBehindANumber", "0,5 mm,0\n", "\"5 mm\" is not a number"},
    {"Percent", "0,5%,0\n", "\"5%\" is not a number"},
    {"OtherLengths", "t [s],x [mm],angle [rad]\n0,0,0\n", "t.csv:1: x is in mm, must be in m"},
    {"OtherAngles", "t [s],x [m],angle [deg]\n0,0,0\n", "t.csv:1: angle is in deg, must be in rad"},
    {"ALineOfOtherUnits", "time,x,angle\ns,mm,rad\n0,0,0\n", "t.csv:2: x is in mm, must be in m"},
    {"OtherColumns", "time,x,y,z\n0,0,0,0\n",
     "t.csv:1: " + numbers + "; the header has the columns time, x, y, z"},
    {"Utf16",
     std::string("\xFF\xFE"
                 "0\0,\0",
                 6),
     "t.csv: is text in UTF-16; save it as UTF-8"},
    {"ASpreadsheetItself", std::string("PK\3\4\0\0\0", 7), "t.csv: is no text"},
};

class BadTableForms : public ::testing::TestWithParam<BadForm> {};

TEST_P(BadTableForms, IsRefusedWithItsLineAndWhatIsExpected) {
  EXPECT_THAT(outcome_of(GetParam().bytes).error, HasSubstr(GetParam().error));
}

INSTANTIATE_TEST_SUITE_P(Table, BadTableForms, ::testing::ValuesIn(bad_forms),
                         [](const auto& form) { return form.param.name; });

/// A case with a moving tank, whose table is in a file.
struct MovingTank {
  MovingTank(const std::string& motion, const std::string& bytes)
      : text("source  =", "tank_motion = { " + motion + " }\nsource  =") {
    std::ofstream(std::filesystem::path(text.file()).parent_path() / "m.csv", std::ios::binary) << bytes;
  }
  std::vector<double> rows() const {
    const auto row = load_case(text.file()).fluid().tank_motion().row();
    return {row.begin(), row.end()};
  }
  CaseText text;
};

TEST(MotionTables, HaveTimeCoordinatesAndAngle) {
  EXPECT_THAT(MovingTank("table = \"m.csv\"", "0,0,0,0\n1,2,3,4\n").rows(),
              ElementsAre(0, 0, 0, 0, 1, 2, 3, 4));
  EXPECT_THAT(errors_of(MovingTank("table = \"m.csv\"", "0,0\n1,2\n").text.file()),
              HasSubstr("m.csv:1: must be 4 numbers: time [s], x [m], y [m], angle [rad]; this line has 2"));
}

TEST(MotionTables, OfTwoColumnsHaveTheCoordinateThatTheCaseNames) {
  const std::string bytes = "0 0\n1 2\n";
  const auto rows = [&](const char* along) {
    return MovingTank(fmt::format("table = \"m.csv\", along = \"{}\"", along), bytes).rows();
  };
  EXPECT_THAT(rows("x"), ElementsAre(0, 0, 0, 0, 1, 2, 0, 0));
  EXPECT_THAT(rows("y"), ElementsAre(0, 0, 0, 0, 1, 0, 2, 0));
  EXPECT_THAT(rows("angle"), ElementsAre(0, 0, 0, 0, 1, 0, 0, 2));
  EXPECT_THAT(errors_of(MovingTank("table = \"m.csv\", along = \"z\"", bytes).text.file()),
              HasSubstr("along = \"z\" is for scenes of three dimensions"));
  EXPECT_THAT(errors_of(MovingTank("along = \"x\"", bytes).text.file()),
              HasSubstr("along and angle_unit are for a table only"));
  EXPECT_THAT(errors_of(MovingTank("angle = 5, frequency = 1, angle_unit = \"deg\"", bytes).text.file()),
              HasSubstr("angle and phase of a formula are in rad"));
}

TEST(MotionTables, MayHaveAnglesInDegrees) {
  const std::string degrees = "table = \"m.csv\", angle_unit = \"deg\"";
  EXPECT_DOUBLE_EQ(MovingTank(degrees, "0,0,0,0\n1,0,0,180\n").rows()[7], 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(MovingTank(degrees, "t,x,y,angle [deg]\n0,0,0,0\n1,0,0,180\n").rows()[7],
                   3.14159265358979323846);
  EXPECT_THAT(errors_of(MovingTank(degrees, "t,x,y,angle [rad]\n0,0,0,0\n1,0,0,3\n").text.file()),
              HasSubstr("angle is in rad, must be in deg"));
}

TEST(MotionTables, StartAtAnyTimeAndGoForward) {
  EXPECT_THAT(MovingTank("table = \"m.csv\"", "-1,0,0,0\n5,2,3,4\n").rows(),
              ElementsAre(-1, 0, 0, 0, 5, 2, 3, 4));
  EXPECT_THAT(
      errors_of(MovingTank("table = \"m.csv\"", "t,x,y,angle\n0,0,0,0\n2,0,0,0\n1,2,3,4\n").text.file()),
      HasSubstr("m.csv:4: times must increase: 1 s after 2 s"));
  EXPECT_THAT(errors_of(MovingTank("table = \"m.csv\"", "0,0,0,0\n").text.file()),
              HasSubstr("m.csv: has 1 rows of time [s], x [m], y [m], angle [rad]; needs at least two"));
}

TEST(CaseFile, MayHaveAByteOrderMarkAndEndsOfLinesOfAnySystem) {
  for (const std::string end : {"\r\n", "\r"}) {
    const CaseText text;
    std::string bytes = "\xEF\xBB\xBF";
    for (const char c : text.text()) bytes += c == '\n' ? end : std::string(1, c);
    std::ofstream(text.file(), std::ios::binary) << bytes;
    EXPECT_EQ(load_case(text.file()).SerializeAsString(), load_case(CaseText().file()).SerializeAsString());
    EXPECT_THAT(errors_of(text.file(), {"fluid.gravity=1"}), HasSubstr("unknown key"));
  }
  const CaseText wide;
  std::ofstream(wide.file(), std::ios::binary) << std::string(
      "\xFF\xFE"
      "a\0",
      4);
  EXPECT_THAT(errors_of(wide.file()), HasSubstr("case.toml: is text in UTF-16; save it as UTF-8"));
}

}  // namespace
}  // namespace cosurge
