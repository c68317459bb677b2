#include "solid_solver/models/relocated_model.hpp"

#include <gtest/gtest.h>

#include "tests/support/loaded_solid.hpp"
#include "tests/support/outlines.hpp"
#include "tests/support/structures.hpp"

namespace cosurge {
namespace {

using test::l0;
using test::LoadedSolid;

/// A flap that tapers, 40 mm high, under gravity across, with its foot at a place.
struct Flap {
  v1::SolidModel::Word model;
  Vec<2> foot;

  v1::Case make() const {
    v1::Case c = test::plate({.columns = 16,
                              .rows = 40,
                              .young_modulus = 2e6,
                              .poisson_ratio = 0.3,
                              .density = 1200,
                              .gravity = {1, 0}});
    v1::Solid& solid = *c.mutable_solid();
    solid.set_model(model);
    solid.mutable_fem()->set_element(0.002);
    v1::Body& body = *solid.mutable_body(0);
    body.clear_box();
    const auto at = [&](double x, double y) { return Vec<2>(foot + Vec<2>(x, y)); };
    *body.mutable_shape() = test::outline<2>({at(0, 0), at(0.016, 0), at(0.012, 0.04), at(0.004, 0.04)});
    *body.mutable_clamp(0) = test::box({foot[0] - 0.01, foot[1] - 0.02}, {foot[0] + 0.03, foot[1]});
    c.mutable_output()->mutable_probe(0)->set_position(0, foot[0] + 0.008);
    c.mutable_output()->mutable_probe(0)->set_position(1, foot[1] + 0.04);
    return c;
  }
  Interface face() const {
    Interface points = test::left_face(38);
    points.position.row(0).array() += foot[0] + 0.006;
    points.position.row(1).array() += foot[1];
    return points;
  }
  /// Displacement of the tip, and of a point of the water, after 10 ms.
  Vec<2> moved() const {
    LoadedSolid run(make(), face());
    Report report;
    for (int k = 0; k < 10; ++k) {
      run.load.force = test::load_of(k, 38);
      report = run.advance(1e-3);
    }
    return {run.value(report, "tip_x"), run.motion.displacement(0, 30)};
  }
};

class FarAway : public testing::TestWithParam<v1::SolidModel::Word> {};

TEST_P(FarAway, BodiesMoveAsAtTheOrigin) {
  const Vec<2> here = Flap{GetParam(), {0.2, 0}}.moved();
  ASSERT_GT(here[0], 1e-6);
  // 9 m are within a hundred lengths of the origin. Positions have a rounding error of 1e-14 m at 90 m and of
  // 1e-9 m in map coordinates, compared with a flap of 0.04 m and cells of 1 mm.
  const std::vector<std::pair<Vec<2>, double>> places = {
      {{3, 0}, 1e-9}, {{90, 0}, 1e-9}, {{-90, 40}, 1e-9}, {{5e5, 5e6}, 2e-5}};
  for (const auto& [foot, off] : places) {
    const Vec<2> there = Flap{GetParam(), foot}.moved();
    EXPECT_NEAR(there[0] / here[0], 1, off) << foot[0];
    EXPECT_NEAR(there[1] / here[1], 1, off) << foot[0];
  }
}

INSTANTIATE_TEST_SUITE_P(All, FarAway,
                         testing::Values(v1::SolidModel::mps, v1::SolidModel::hamiltonian,
                                         v1::SolidModel::fem, v1::SolidModel::modal),
                         [](const auto& choice) { return v1::SolidModel::Word_Name(choice.param); });

TEST(RelocatedModel, FramesAreWhereTheBodyIs) {
  LoadedSolid run(Flap{v1::SolidModel::fem, {90, 0}}.make(), {});
  const Snapshot arrays = run.solid.frame();
  EXPECT_NEAR(arrays.at(0).values.at(0), 90, 0.02);
}

TEST(RelocatedModel, MessagesSayWhatTheirCoordinatesMean) {
  const Flap flap{v1::SolidModel::fem, {90, 0}};
  Interface points = flap.face();
  points.position.row(0).array() += 0.1;
  try {
    LoadedSolid run(flap.make(), points);
    FAIL() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("counted from (90.008, 0.02)"), std::string::npos)
        << error.what();
  }
}

TEST(RelocatedModel, BodiesNearTheOriginStayWhereTheyAre) {
  EXPECT_FALSE(origin_near_bodies(structure_from_case<2>(Flap{v1::SolidModel::fem, {3, 0}}.make())));
  EXPECT_TRUE(origin_near_bodies(structure_from_case<2>(Flap{v1::SolidModel::fem, {90, 0}}.make())));
}

}  // namespace
}  // namespace cosurge
