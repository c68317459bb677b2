#include "common/case/case_differences.hpp"

#include <sstream>

#include "common/case/case_overrides.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

std::string text(const toml::node* node) {
  if (node == nullptr) return "none";
  if (const auto number = node->value_exact<double>())
    return fmt::format("{}", *number);  // as short as it is exact
  std::ostringstream out;
  node->visit([&](const auto& value) { out << value; });
  return out.str();
}

void compare(const std::string& key, const toml::node* a, const toml::node* b,
             std::vector<Difference>& found) {
  const toml::table *table_a = a ? a->as_table() : nullptr, *table_b = b ? b->as_table() : nullptr;
  const auto child = [&](const auto& name) {
    return key.empty() ? std::string(name) : fmt::format("{}.{}", key, name);
  };
  if (table_a != nullptr && table_b != nullptr) {
    for (const auto& [name, value] : *table_a) compare(child(name.str()), &value, table_b->get(name), found);
    for (const auto& [name, value] : *table_b)
      if (!table_a->contains(name)) compare(child(name.str()), nullptr, &value, found);
    return;
  }
  const toml::array *list_a = a ? a->as_array() : nullptr, *list_b = b ? b->as_array() : nullptr;
  if (list_a != nullptr && list_b != nullptr && list_a->size() == list_b->size()) {
    const std::size_t before = found.size();
    for (std::size_t k = 0; k < list_a->size(); ++k)
      compare(child(std::to_string(k)), list_a->get(k), list_b->get(k), found);
    constexpr std::size_t few = 4;
    if (found.size() <= before + few) return;
    found.resize(before);  // an outline or a table is one value
    return found.push_back({.key = key, .first = "a list", .second = "another list of this length"});
  }
  if (const std::string first = text(a), second = text(b); first != second)
    found.push_back({.key = key, .first = first, .second = second});
}

}  // namespace

std::vector<Difference> differences(const v1::Case& first, const v1::Case& second) {
  const toml::table a = tree_of(first), b = tree_of(second);
  std::vector<Difference> found;
  compare("", &a, &b, found);
  return found;
}

}  // namespace cosurge
