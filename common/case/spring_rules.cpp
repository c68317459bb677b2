#include "common/case/spring_rules.hpp"

#include <algorithm>
#include <vector>

#include "common/error.hpp"

namespace cosurge {
namespace {

std::vector<v1::Spring::Motion> motions_of(int dimension) {
  if (dimension == 2) return {v1::Spring::x, v1::Spring::y, v1::Spring::turn};
  return {v1::Spring::x,      v1::Spring::y,      v1::Spring::z,
          v1::Spring::turn_x, v1::Spring::turn_y, v1::Spring::turn_z};
}

}  // namespace

void check_springs(const v1::Case& c, CaseErrors& errors) {
  if (c.solid().model() != v1::SolidModel::sprung) return;
  const v1::SolidSprung& sprung = c.solid().sprung();
  if (sprung.spring().empty())
    errors.add("solid.sprung.spring",
               "missing: no motion is free; name a motion, or choose solid.model = \"rigid\"");
  if (sprung.pivot_size() > 0 && sprung.pivot_size() != c.dimension())
    errors.add("solid.sprung.pivot",
               fmt::format("has {} components, must have {}", sprung.pivot_size(), c.dimension()));
  const std::vector<v1::Spring::Motion> allowed = motions_of(c.dimension());
  std::vector<std::string> words;
  for (const v1::Spring::Motion motion : allowed) words.push_back(v1::Spring::Motion_Name(motion));
  int seen = 0, turns = 0;  // bits
  for (int i = 0; i < sprung.spring_size(); ++i) {
    const v1::Spring::Motion motion = sprung.spring(i).motion();
    const std::string key = fmt::format("solid.sprung.spring.{}.motion", i);
    if (std::find(allowed.begin(), allowed.end(), motion) == allowed.end())
      errors.add(key, fmt::format("no \"{}\" in {} dimensions; allowed: {}", v1::Spring::Motion_Name(motion),
                                  c.dimension(), fmt::join(words, ", ")));
    if ((seen >> motion & 1) != 0)
      errors.add(key, fmt::format("a second spring for \"{}\"; only one is allowed",
                                  v1::Spring::Motion_Name(motion)));
    else if (motion >= v1::Spring::turn_x)
      ++turns;
    seen |= 1 << motion;
  }
  if (turns == 2)
    errors.add("solid.sprung.spring",
               "turns about two axes; give one of turn_x, turn_y and turn_z, or all three (a stiff spring "
               "blocks one)");
}

}  // namespace cosurge
