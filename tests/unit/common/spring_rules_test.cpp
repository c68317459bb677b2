#include "common/case/spring_rules.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cosurge {
namespace {

using ::testing::HasSubstr;

struct Row {
  std::string name;
  int dimension;
  std::vector<v1::Spring::Motion> motions;
  std::vector<std::string> errors;
  std::size_t pivot = 0;  // components
};

const Row rows[] = {
    {"AllOfThePlane", 2, {v1::Spring::x, v1::Spring::y, v1::Spring::turn}, {}},
    {"AllOfSpace",
     3,
     {v1::Spring::x, v1::Spring::y, v1::Spring::z, v1::Spring::turn_x, v1::Spring::turn_y,
      v1::Spring::turn_z},
     {}},
    {"AHinge", 3, {v1::Spring::turn_y}, {}, 3},
    {"None", 2, {}, {"solid.sprung.spring: missing: no motion is free"}},
    {"TurnInSpace",
     3,
     {v1::Spring::turn},
     {"spring.0.motion: no \"turn\" in 3 dimensions; allowed: x, y, z, turn_x, turn_y, turn_z"}},
    {"SpaceInThePlane",
     2,
     {v1::Spring::z, v1::Spring::turn_y},
     {"spring.0.motion: no \"z\" in 2 dimensions; allowed: x, y, turn", "spring.1.motion: no \"turn_y\""}},
    {"Twice",
     3,
     {v1::Spring::x, v1::Spring::x, v1::Spring::turn_x, v1::Spring::turn_x},
     {"spring.1.motion: a second spring for \"x\"", "spring.3.motion: a second spring for \"turn_x\""}},
    {"TwoAxes", 3, {v1::Spring::turn_x, v1::Spring::turn_z}, {"turns about two axes"}},
    {"APivotOfThePlane", 3, {v1::Spring::turn_z}, {"solid.sprung.pivot: has 2 components, must have 3"}, 2},
};

class SpringRules : public ::testing::TestWithParam<Row> {};

TEST_P(SpringRules, NameAllThatIsWrong) {
  const Row& row = GetParam();
  v1::Case c;
  c.set_dimension(row.dimension);
  c.mutable_solid()->set_model(v1::SolidModel::sprung);
  v1::SolidSprung& sprung = *c.mutable_solid()->mutable_sprung();
  for (const auto motion : row.motions) sprung.add_spring()->set_motion(motion);
  for (std::size_t k = 0; k < row.pivot; ++k) sprung.add_pivot(0);
  CaseErrors errors;
  check_springs(c, errors);
  ASSERT_EQ(errors.lines.size(), row.errors.size());
  for (std::size_t k = 0; k < row.errors.size(); ++k) EXPECT_THAT(errors.lines[k], HasSubstr(row.errors[k]));
  c.mutable_solid()->set_model(v1::SolidModel::fem);  // another model has no use for them
  CaseErrors none;
  check_springs(c, none);
  EXPECT_TRUE(none.lines.empty());
}

INSTANTIATE_TEST_SUITE_P(Springs, SpringRules, ::testing::ValuesIn(rows),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace cosurge
