#include "common/case/several_solids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/case/case_differences.hpp"
#include "common/case/case_doubts.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

const std::string hull_case = COSURGE_SOURCE_DIR "/cases/rigid_hull";

v1::Case hull(const std::vector<std::string>& overrides = {}) { return load_case(hull_case, overrides); }

/// The errors of the case with these values.
std::string errors_with(const std::vector<std::string>& overrides) {
  try {
    hull(overrides);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SeveralSolids, HaveAllTheirBodiesInOneListInTheirOrder) {
  const v1::Case c = hull();
  EXPECT_THAT(solid_names(c), ElementsAre("hull", "panel"));
  ASSERT_EQ(c.solid().body_size(), 4);
  std::vector<std::string> names;
  for (const v1::Body& body : c.solid().body()) names.push_back(solid_of(c, body).name());
  EXPECT_THAT(names, ElementsAre("hull", "hull", "hull", "panel"));
  EXPECT_TRUE(c.has_coupling());
}

TEST(SeveralSolids, EachHasACaseWithItsOwnBodiesAndProbes) {
  const v1::Case c = hull();
  const v1::Case first = case_of_solid(c, 0), second = case_of_solid(c, 1);
  EXPECT_EQ(first.solid().model(), v1::SolidModel::rigid);
  EXPECT_EQ(first.solid().body_size(), 3);
  ASSERT_EQ(first.output().probe_size(), 1);
  EXPECT_EQ(first.output().probe(0).name(), "side");
  EXPECT_EQ(second.solid().model(), v1::SolidModel::fem);
  EXPECT_EQ(second.solid().body_size(), 1);
  ASSERT_EQ(second.output().probe_size(), 1);
  EXPECT_EQ(second.output().probe(0).name(), "middle");
  for (const v1::Case& one : {first, second}) EXPECT_FALSE(has_several_solids(one));
}

TEST(SeveralSolids, ClampsInARigidBodyOfAnotherMoveWithIt) {
  const v1::Case c = hull();
  EXPECT_FALSE(c.solids(1).body(0).has_motion());
  EXPECT_EQ(case_of_solid(c, 1).solid().body(0).motion().SerializeAsString(),
            c.solids(0).body(1).motion().SerializeAsString());
  EXPECT_THAT(errors_with({"solid.0.body.2.motion.frequency=3"}),
              HasSubstr("solid.1.body.0.clamp: its clamps lie in solid.0.body.1 and in solid.0.body.2, which "
                        "move differently"));
  EXPECT_THAT(errors_with({"solid.0.model=fem", "solid.0.young_modulus=1e9"}),
              HasSubstr("solid.1.body.0.clamp: its clamps lie in solid.0.body.1, whose motion is computed"));
}

TEST(SeveralSolids, OfAListWithOneEntryAreOne) {
  const std::string water =
      "title = \"one\"\ngravity = [0.0, -9.81]\n[time]\nend = 0.1\n[fluid]\nspacing = 0.01\n"
      "tank = { min = [0.0, 0.0], max = [0.4, 0.4] }\n"
      "water = [{ min = [0.0, 0.0], max = [0.4, 0.1] }]\n";
  const std::string rest =
      "density = 1000.0\nmodel = \"rigid\"\n"
      "body = [{ box = { min = [0.1, 0.2], max = [0.2, 0.3] } }]\n";
  const v1::Case one = read_case(water + "[solid]\n" + rest),
                 listed = read_case(water + "[[solid]]\n" + rest);
  EXPECT_EQ(one.SerializeAsString(), listed.SerializeAsString());
  EXPECT_THAT(solid_names(one), ElementsAre("solid"));
}

TEST(SeveralSolids, SayAllErrorsAtOnceWithTheKeysOfTheFile) {
  const std::string errors =
      errors_with({"solid.1.name=hull", "solid.1.young_modulus=none", "solid.1.spacing=0.004",
                   "solid.0.body.1.box={min=[0.18, 0.17], max=[0.23, 0.215]}",
                   "solid.1.body.0.support=[{ box = { min = [0, 0], max = [0.01, 0.01] } }]"});
  EXPECT_THAT(errors, AllOf(HasSubstr("solid.1.name: \"hull\" is taken"),
                            HasSubstr("solid.1.young_modulus: missing, the model fem needs it"),
                            HasSubstr("solid.1.spacing: 0.004 does not divide solid.1.body.0.box"),
                            HasSubstr("solid.1.body.0.box: overlaps solid.0.body.1.box"),
                            HasSubstr("solid.1.body.0.support.0.box: must touch the body")));
  EXPECT_THAT(errors, Not(HasSubstr("solid.body")));
}

TEST(SeveralSolids, NeedNamesThatTheResultsDoNotHave) {
  EXPECT_THAT(errors_with({"solid.0.name=none"}), HasSubstr("solid.0.name: missing"));
  EXPECT_THAT(errors_with({"solid.0.name=\"a/b\""}), HasSubstr("must consist of letters, digits and _"));
  for (const std::string taken : {"fluid", "solid", "coupling"})
    EXPECT_THAT(errors_with({"solid.0.name=" + taken}), HasSubstr("\"" + taken + "\" is taken"));
}

TEST(SeveralSolids, NeedWaterAndAreNotAnEmptyList) {
  EXPECT_THAT(errors_with({"fluid=none", "output=none", "solid.0.spacing=0.005", "solid.1.spacing=0.005"}),
              HasSubstr("solid: several [[solid]] need a [fluid]"));
  EXPECT_THAT(errors_with({"solid=[]"}), HasSubstr("solid: has no entries"));
  EXPECT_THAT(errors_with({"solids=[]"}), HasSubstr("solids: unknown key"));
  EXPECT_THAT(errors_with({"solid.0.body.0.solid=1"}), HasSubstr("solid.0.body.0.solid: unknown key"));
}

TEST(SeveralSolids, ChangeAndCompareByTheKeysOfTheFile) {
  const v1::Case c = hull(), changed = change_case(c, {"solid.1.density=1300", "time.end=0.5"});
  EXPECT_EQ(changed.solids(1).density(), 1300);
  EXPECT_EQ(change_case(c, {}).SerializeAsString(), c.SerializeAsString());
  std::vector<std::string> keys;
  for (const Difference& one : differences(c, changed)) keys.push_back(one.key);
  EXPECT_THAT(keys, ::testing::UnorderedElementsAre("solid.1.density", "time.end"));
}

TEST(SeveralSolids, AreDoubtedByTheKeysOfTheFile) {
  const std::vector<std::string> all =
      doubts(hull({"solid.1.young_modulus=1e20", "solid.0.body.2.motion={}", "solid.1.body.0.motion={}",
                   "solid.0.body.1.motion.amplitude=[0.0, -30.0]"}));
  EXPECT_THAT(all, ::testing::Contains(HasSubstr("solid.1.young_modulus: 1e+20 Pa is outside")));
  EXPECT_THAT(all, ::testing::Contains(HasSubstr("solid.0.body.1.motion: moves at")));
}

}  // namespace
}  // namespace cosurge
