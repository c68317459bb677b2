#include "common/case/several_solids.hpp"

#include <fmt/format.h>

#include <regex>

#include "common/case/bodies.hpp"
#include "common/case/carriers.hpp"

namespace cosurge {
namespace {

/// Replaces what a pattern finds; `replaced` makes the new text of a match.
template <typename Replace>
std::string replace_all(const std::string& text, const std::regex& pattern, const Replace& replaced) {
  std::string out;
  auto rest = text.cbegin();
  for (std::smatch found; std::regex_search(rest, text.cend(), found, pattern); rest = found[0].second)
    out.append(rest, found[0].first).append(replaced(found));
  return out.append(rest, text.cend());
}

}  // namespace

std::vector<std::string> solid_names(const v1::Case& the_case) {
  std::vector<std::string> names;
  for (const v1::Solid& solid : the_case.solids()) names.push_back(solid.name());
  if (names.empty() && the_case.has_solid()) names.emplace_back("solid");
  return names;
}

int first_body(const v1::Case& the_case, int solid) {
  int first = 0;
  for (int k = 0; k < solid; ++k) first += the_case.solids(k).body_size();
  return first;
}

const v1::Solid& solid_of(const v1::Case& the_case, const v1::Body& body) {
  const bool one_of_several = body.has_solid() && body.solid() < the_case.solids_size();
  return one_of_several ? the_case.solids(body.solid()) : the_case.solid();
}

void join_solids(v1::Case& the_case) {
  if (the_case.solids_size() == 0) return;
  if (the_case.solids_size() == 1) {
    the_case.mutable_solid()->Swap(the_case.mutable_solids(0));
    the_case.clear_solids();
    return;
  }
  v1::Solid& all = *the_case.mutable_solid();
  all.Clear();
  all.set_density(the_case.solids(0).density());  // required, and read of the structures themselves
  for (int k = 0; k < the_case.solids_size(); ++k)
    for (const v1::Body& body : the_case.solids(k).body()) {
      *all.add_body() = body;
      all.mutable_body(all.body_size() - 1)->set_solid(k);
    }
}

v1::Case case_of_solid(const v1::Case& the_case, int solid) {
  v1::Case one = the_case;
  if (!has_several_solids(the_case)) return one;
  *one.mutable_solid() = the_case.solids(solid);
  one.clear_solids();
  const int first = first_body(the_case, solid);
  for (int b = 0; b < one.solid().body_size(); ++b)
    if (const v1::Body& body = the_case.solid().body(first + b); is_held_by_another(the_case, body))
      *one.mutable_solid()->mutable_body(b)->mutable_motion() = motion_of(the_case, body);
  one.mutable_output()->clear_probe();
  for (const v1::Probe& probe : the_case.output().probe()) {
    if (probe.quantity() != v1::Probe::displacement) continue;
    const int body = body_at(the_case.solid(), probe.position()) - first;
    if (body >= 0 && body < one.solid().body_size()) *one.mutable_output()->add_probe() = probe;
  }
  return one;
}

std::string with_written_keys(const v1::Case& the_case, const std::string& text) {
  if (!has_several_solids(the_case)) return text;
  static const std::regex key(R"(\bsolid\.body\.(\d+))");
  return replace_all(text, key, [&](const std::smatch& found) -> std::string {
    const int body = std::stoi(found[1].str());
    if (body >= the_case.solid().body_size()) return found[0].str();
    const int solid = the_case.solid().body(body).solid();
    return fmt::format("solid.{}.body.{}", solid, body - first_body(the_case, solid));
  });
}

std::string with_written_keys(int solid, const std::string& text) {
  static const std::regex key(R"(\bsolid\.(?=[a-z]))");
  return replace_all(text, key, [&](const std::smatch&) { return fmt::format("solid.{}.", solid); });
}

}  // namespace cosurge
