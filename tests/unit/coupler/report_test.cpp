// The data of the report page.
#include <zlib.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>

#include "coupler/report/case_table.hpp"
#include "coupler/report/outlines.hpp"
#include "coupler/report/packed_frames.hpp"
#include "coupler/report/packed_histories.hpp"
#include "coupler/report/packing.hpp"
#include "coupler/report/page.hpp"
#include "coupler/report/reference_curves.hpp"
#include "coupler/report/run_document.hpp"
#include "coupler/report/run_numbers.hpp"
#include "coupler/report/scene.hpp"
#include "tests/support/case_text.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;
using testing::ScratchFolder;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::uint8_t> unpacked(const std::string& text, std::size_t size) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> stream;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    stream.push_back(static_cast<std::uint8_t>(bits >> count & 255));
  }
  std::vector<std::uint8_t> bytes(size);
  uLongf length = size;
  EXPECT_EQ(uncompress(bytes.data(), &length, stream.data(), stream.size()), Z_OK);
  EXPECT_EQ(length, size);
  return bytes;
}

/// Particles that go around circles; the last one is lost, in its own way, in the third frame.
class Turning : public FrameSource {
 public:
  static constexpr std::size_t count = 50;

  explicit Turning(int dimension)
      : FrameSource(
            {{.name = "position", .unit = "m", .frames = 5, .particles = count, .components = dimension},
             {.name = "kind", .unit = "-", .frames = 5, .particles = count},
             {.name = "pressure", .unit = "Pa", .frames = 5, .particles = count},
             {.name = "velocity", .unit = "m/s", .frames = 5, .particles = count, .components = dimension}}),
        dimension_(dimension) {}

 private:
  std::vector<float> values(const FrameArray& array, std::size_t frame) const override {
    std::vector<float> out;
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = 0.1 * double(frame) + double(k), radius = 0.01 * double(k);
      const bool lost = k + 1 == count && frame >= 2;
      if (array.name == "kind") out.push_back(k % 10 == 3 ? 1 : 0);
      if (array.name == "pressure") out.push_back(static_cast<float>(10.0 * double(k) * double(frame)));
      if (array.name == "position" || array.name == "velocity")
        for (int axis = 0; axis < dimension_; ++axis)
          out.push_back(
              static_cast<float>(lost ? nan : radius * std::cos(angle - axis * std::numbers::pi / 2)));
    }
    return out;
  }

  int dimension_;
};

std::uint16_t word(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t k, std::size_t n) {
  return static_cast<std::uint16_t>(bytes[at + k] | bytes[at + n + k] << 8);
}

/// Unpacks by the rules of packed_frames.hpp, without its code.
void expect_frames_back(int dimension) {
  const Turning source(dimension);
  Cast cast{.member = "fluid", .particles = {}, .finest = 0, .quantities = {"pressure", "speed"}};
  for (std::size_t k = 0; k < Turning::count; k += 7) cast.particles.push_back(k);
  cast.particles.push_back(Turning::count - 1);
  const std::size_t n = cast.particles.size(), frames = 5, axes = static_cast<std::size_t>(dimension);
  const Json chunk = pack_frames(source, cast, {0, 1, 2, 3, 4});
  const auto bytes = unpacked(chunk["data"], frames * n * (2 * axes + 3));
  std::vector<std::vector<std::uint16_t>> x(frames, std::vector<std::uint16_t>(n * axes));
  std::vector<std::uint8_t> kind(n, 0), pressure(n, 0), speed(n, 0);
  std::size_t at = 0;
  const double step = chunk["step"];
  for (std::size_t f = 0; f < frames; ++f) {
    const auto place = source.read("position", f), velocity = source.read("velocity", f),
               p = source.read("pressure", f);
    for (std::size_t axis = 0; axis < axes; ++axis, at += 2 * n)
      for (std::size_t k = 0; k < n; ++k) {
        const std::uint16_t w = word(bytes, at, k, n);
        const std::size_t i = axis * n + k;
        const int expected = f == 0 ? 0 : f == 1 ? x[0][i] : 2 * x[f - 1][i] - x[f - 2][i];
        x[f][i] = static_cast<std::uint16_t>(expected + ((w >> 1) ^ -(w & 1)));
      }
    for (std::size_t k = 0; k < n; ++k, ++at) kind[k] = static_cast<std::uint8_t>(kind[k] + bytes[at]);
    for (std::size_t k = 0; k < n; ++k, ++at)
      pressure[k] = static_cast<std::uint8_t>(pressure[k] + bytes[at]);
    for (std::size_t k = 0; k < n; ++k, ++at) speed[k] = static_cast<std::uint8_t>(speed[k] + bytes[at]);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t particle = cast.particles[k];
      if (particle + 1 == Turning::count && f >= 2) {
        EXPECT_EQ(kind[k], 5) << "lost in frame " << f;
        continue;
      }
      EXPECT_EQ(kind[k], particle % 10 == 3 ? 1 : 0);
      double square = 0;
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const double value = place[particle * axes + axis];
        const double back = double(chunk["origin"][axis]) + step * x[f][axis * n + k];
        EXPECT_NEAR(back, value, 0.51 * step);
        square += std::pow(velocity[particle * axes + axis], 2);
      }
      const auto value_of = [&](int q, double byte) {
        const Json& quantity = chunk["quantities"][static_cast<std::size_t>(q)];
        return double(quantity["min"]) +
               (double(quantity["max"]) - double(quantity["min"])) * std::pow(byte / 255, 2);
      };
      const double highest = chunk["quantities"][0]["max"];
      EXPECT_NEAR(value_of(0, pressure[k]), p[particle], highest / 255);
      EXPECT_NEAR(value_of(1, speed[k]), std::sqrt(square), double(chunk["quantities"][1]["max"]) / 255);
    }
  }
  EXPECT_EQ(at, bytes.size());
}

TEST(PackedFrames, ComeBackToHalfAStepOfTheirGridInTwoAndThreeDimensions) {
  expect_frames_back(2);
  expect_frames_back(3);
}

TEST(PackedFrames, OfEvenMotionTakeAFewBytesAParticle) {
  const Turning source(2);
  Cast cast{.member = "fluid", .particles = {}, .finest = 1e-3, .quantities = {}};
  for (std::size_t k = 0; k + 1 < Turning::count; ++k) cast.particles.push_back(k);
  const std::string data = pack_frames(source, cast, {0, 1, 2, 3, 4})["data"];
  EXPECT_LT(double(data.size()) / double(5 * cast.particles.size()),
            3);  // 4 without any packing, 5.3 in base64
}

TEST(Packing, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
  const auto of = [](const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
}

v1::Case probed_case() {
  v1::Case c;
  c.set_title("probed");
  c.mutable_time()->set_end(1);
  const auto add = [&](const std::string& name, v1::Probe::Quantity quantity) {
    v1::Probe& probe = *c.mutable_output()->add_probe();
    probe.set_name(name);
    probe.set_quantity(quantity);
    probe.add_position(0.1);
    probe.add_position(0.2);
  };
  add("tip", v1::Probe::displacement);
  add("P01", v1::Probe::pressure);
  return c;
}

TEST(ReferenceCurves, GoToTheHistoriesThatTheirColumnsName) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "reference");
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / "reference" / name) << text;
  };
  write("somebody_2005.csv", "t_s,ux_m\n0,0\n0.5,0.25\n");
  write("pressures.csv", "t_s,P01_Pa\n0,1\n\n1,2\n");
  write("fronts.csv", "t,z\n0,1\n");
  write("broken.csv", "t_s,tip_y_m\n0,1\n1;2\n");
  const Json curves = reference_curves(folder.path(), probed_case());
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0]["column"], "solid/tip_y");
  EXPECT_NE(std::string(curves[0]["error"]).find("broken.csv:3"), std::string::npos) << curves[0];
  EXPECT_EQ(curves[1]["column"], "fluid/P01");
  EXPECT_EQ(curves[1]["values"], Json({1.0, 2.0}));
  EXPECT_EQ(curves[2]["column"], "solid/tip_x");
  EXPECT_EQ(curves[2]["name"], "Somebody 2005");
  EXPECT_EQ(curves[2]["time"], Json({0.0, 0.5}));
}

RunRecord record_of(std::vector<Series> more, const std::string& status = "finished") {
  std::vector<Series> all = {{.name = "time", .unit = "s", .values = {0.25, 0.5, 1.0}},
                             {.name = "window", .unit = "s", .values = {0.25, 0.25, 0.5}}};
  all.insert(all.end(), more.begin(), more.end());
  return {all, {{"status", status}, {"reason", "why"}}};
}

TEST(Verdict, NamesWhatARunItselfWarnsOf) {
  const v1::Case c = probed_case();
  EXPECT_EQ(verdict(record_of({}), c)["level"], "good");
  EXPECT_EQ(verdict(record_of({}, "interrupted"), c)["level"], "doubt");
  EXPECT_EQ(verdict(record_of({}, "failed"), c)["level"], "bad");
  const Series work{.name = "coupling/work_points", .unit = "J", .values = {0, 1, 0.5}};
  const auto created = [&](double joules) {
    return verdict(
        record_of({work, {.name = "coupling/work_created", .unit = "J", .values = {0, 0, joules}}}), c);
  };
  EXPECT_EQ(created(0.07)["level"], "good");  // 5 % of the 1.5 J that have passed are 0.075 J
  EXPECT_EQ(created(0.08)["level"], "bad");
  const Series lost{.name = "fluid/lost", .unit = "-", .values = {0, 0, 1}};
  const auto left = [&](double particles) {
    return verdict(record_of({lost, {.name = "fluid/water", .unit = "-", .values = {0, 0, particles}}}), c);
  };
  EXPECT_EQ(left(999)["level"], "doubt");
  EXPECT_EQ(left(9)["level"], "bad");  // a tenth, where the case allows a hundredth
}

TEST(Extremes, HaveTheirTimesAndProbesFirst) {
  const RunRecord run = record_of({{.name = "coupling/force_x", .unit = "N", .values = {1, -4, 2}},
                                   {.name = "fluid/seconds_predict", .unit = "s", .values = {1, 2, 3}},
                                   {.name = "fluid/P01", .unit = "Pa", .values = {nan, 3, 1}}});
  const Json rows = extremes(run, probed_case());
  EXPECT_EQ(rows[0]["name"], "fluid/P01");
  EXPECT_EQ(rows[0]["peak"], 3.0);
  EXPECT_EQ(rows[0]["peak_time"], 0.5);
  const Json& force = rows[2];
  EXPECT_EQ(force["name"], "coupling/force_x");
  EXPECT_EQ(force["peak"], -4.0);
  EXPECT_EQ(force["max_time"], 1.0);
  EXPECT_EQ(rows.size(), 3U) << "clocks are no histories: " << rows;
  // Trapezia: 0.25 (1 - 4) / 2 + 0.5 (-4 + 2) / 2
  EXPECT_EQ(impulses(run, probed_case())[0]["value"], -0.875);
}

TEST(PackedHistories, OfALongRunKeepEveryPeak) {
  const std::size_t rows = 100000;
  std::vector<double> time(rows), values(rows, 0);
  for (std::size_t k = 0; k < rows; ++k) time[k] = double(k + 1) * 1e-5;
  values[77777] = 5;
  values[77779] = -7;
  const RunRecord run(
      {{.name = "time", .unit = "s", .values = time}, {.name = "fluid/front", .unit = "m", .values = values}},
      {});
  const Json tables = pack_histories(run, probed_case());
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0]["exact"], false);
  const std::size_t kept = tables[0]["rows"];
  EXPECT_EQ(kept, 8192U);
  const auto bytes = unpacked(tables[0]["data"], kept * 12);
  std::vector<float> back(kept);
  for (std::size_t k = 0; k < kept; ++k) {
    std::uint8_t value[4];
    for (std::size_t b = 0; b < 4; ++b) value[b] = bytes[kept * (8 + b) + k];
    std::memcpy(&back[k], value, 4);
  }
  EXPECT_EQ(*std::max_element(back.begin(), back.end()), 5);
  EXPECT_EQ(*std::min_element(back.begin(), back.end()), -7);
}

TEST(CaseTable, HasTheUnitsOfTheSchema) {
  const Json rows = case_table(probed_case());
  const auto row = [&](const std::string& key) {
    for (const Json& entry : rows)
      if (entry[0] == key) return entry;
    return Json();
  };
  EXPECT_EQ(row("time.end"), Json({"time.end", "1", "s"}));
  EXPECT_EQ(row("output.probe.1.position"), Json({"output.probe.1.position", "0.1, 0.2", "m"}));
  EXPECT_EQ(row("output.probe.0.quantity"), Json({"output.probe.0.quantity", "displacement", ""}));
}

TEST(Outlines, OfAWallThatMovesAreWhereItGoes) {
  v1::Case c = probed_case();
  const auto box = [](v1::Box& b, double x, double y) {
    b.add_min(0), b.add_min(0), b.add_max(x), b.add_max(y);
  };
  box(*c.mutable_fluid()->mutable_tank(), 1, 2);
  v1::WallMotion& motion = *c.mutable_fluid()->mutable_tank_motion();
  motion.add_amplitude(0.1), motion.add_amplitude(0);
  motion.set_frequency(1);
  const Json tank = outlines(c, {0, 0.25})[0];
  EXPECT_EQ(tank["lines"][0].size(), 4U) << "open at the top";
  EXPECT_EQ(tank["poses"][0], Json({0.0, 0.0, 1.0, 0.0, 0.0, 1.0}));
  EXPECT_NEAR(tank["poses"][1][0], 0.1, 1e-12);
  double least = 0, most = 0;
  for (const Json& part : outlines_of_check(c))
    if (part["kind"] == "extreme") {
      least = std::min(least, double(part["lines"][0][1][0]));
      most = std::max(most, double(part["lines"][0][1][0]));
    }
  EXPECT_NEAR(least, -0.1, 1e-6);
  EXPECT_NEAR(most, 0.1, 1e-6);
}

TEST(Page, TakesNoRunsOfDifferentDimensions) {
  const auto run = [](const std::string& name, int dimension) {
    return Json{{"name", name}, {"dimension", dimension}};
  };
  EXPECT_NO_THROW(page_document("report", Json::array({run("a", 2), run("b", 2)})));
  EXPECT_THROW(page_document("report", Json::array({run("a", 2), run("b", 3)})), Error);
}

TEST(Page, LetsNoTextEndItsScript) {
  const std::string text = json_for_html({{"title", "</script><b>"}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["title"], "</script><b>");
  const std::string whole = page({{"title", "mark of the test"}});
  EXPECT_NE(whole.find("mark of the test"), std::string::npos);
  EXPECT_EQ(whole.find("@COSURGE_DOCUMENT@"), std::string::npos);
  for (const std::string outside : {"src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_EQ(whole.find(outside), std::string::npos) << "the page loads something: " << outside;
}

TEST(Scene, ShowsFewerFramesBeforeFewerParticles) {
  v1::Case c = probed_case();
  c.mutable_fluid()->set_spacing(0.01);
  const Turning fluid(2);
  const Turning none(2);
  const auto choice = [&](std::size_t frames, double megabytes) {
    return choose(c, fluid, fluid, frames, megabytes);
  };
  EXPECT_EQ(choice(100, 5).every_frame, 1U);
  EXPECT_EQ(choice(1000, 0.3).every_particle, 1U);
  EXPECT_GT(choice(1000, 0.3).every_frame, 1U);
  const SceneChoice few = choice(1000, 0.01);
  EXPECT_EQ(few.every_frame, 10U) << "a hundred frames stay";
  EXPECT_GT(few.every_particle, 1U);
  EXPECT_LT(few.casts[0].particles.size(), Turning::count);
  EXPECT_EQ(few.casts[1].particles.size(), Turning::count) << "the structure stays whole";
}

/// 16 x 16 particles of water at rest on a lattice.
class Lattice : public FrameSource {
 public:
  Lattice()
      : FrameSource({{.name = "position", .unit = "m", .frames = 1, .particles = 256, .components = 2},
                     {.name = "kind", .unit = "-", .frames = 1, .particles = 256}}) {}

 private:
  std::vector<float> values(const FrameArray& array, std::size_t) const override {
    if (array.name == "kind") return std::vector<float>(256, 0);
    std::vector<float> x;
    for (int k = 0; k < 256; ++k) x.insert(x.end(), {float(k % 16), float(k / 16)});
    return x;
  }
};

TEST(Scene, ThinsOutALatticeEvenly) {
  v1::Case c = probed_case();
  c.mutable_fluid()->set_spacing(1);
  const SceneChoice choice = choose(c, Lattice(), SnapshotFrames({}, "solid"), 100, 0.022);
  ASSERT_EQ(choice.every_particle, 8U) << "the test wants a divisor of the 16 columns";
  std::set<std::size_t> columns;
  for (const std::size_t particle : choice.casts[0].particles) columns.insert(particle % 16);
  EXPECT_NEAR(double(choice.casts[0].particles.size()), 256.0 / 8, 2);
  EXPECT_GT(columns.size(), 12U);  // every eighth particle would have two
}

}  // namespace
}  // namespace cosurge
