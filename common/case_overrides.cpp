#include "common/case_overrides.hpp"

#include <optional>

#include "common/error.hpp"
#include "common/toml_bounds.hpp"

namespace cosurge {
namespace {

/// The value of an override: TOML, or a bare word.
toml::table parse_value(const std::string& source, const std::string& value) {
  try {
    return toml::parse("value = " + value, source);
  } catch (const toml::parse_error&) {
    require(value.find_first_of("'\n\r") == std::string::npos,
            "{}: \"{}\" is neither a TOML value nor a word", source, value);
    return toml::parse("value = '" + value + "'", source);
  }
}

/// The entry of a list that `key` means, if there is one.
std::optional<std::size_t> entry_of(const toml::array& items, const std::string& key) {
  const bool numeric =
      !key.empty() && key.size() < 9 && key.find_first_not_of("0123456789") == std::string::npos;
  if (!numeric || std::stoul(key) >= items.size()) return std::nullopt;
  return std::stoul(key);
}

/// Walks down `keys` from `node`, making tables where there are none; null where the way leads through a
/// value.
toml::node* descend(toml::node* node, const std::string& key) {
  if (toml::table* inner = node->as_table()) {
    if (!inner->contains(key)) inner->insert(key, toml::table{});
    return inner->get(key);
  }
  if (toml::array* items = node->as_array())
    if (const auto entry = entry_of(*items, key)) return items->get(*entry);
  return nullptr;
}

}  // namespace

void apply_override(toml::table& root, const std::string& text) {
  const auto equals = text.find('=');
  require(equals != std::string::npos && equals > 0, "--set {}: must be key.path=value", text);
  const std::string key = text.substr(0, equals);
  const std::string source = "--set " + text;
  require_short_keys(text, fmt::format("--set {:.60}", text));
  toml::table parsed = parse_value(source, text.substr(equals + 1));
  toml::node* node = &root;
  std::size_t start = 0;
  for (auto dot = key.find('.'); dot != std::string::npos && node != nullptr; dot = key.find('.', start)) {
    node = descend(node, key.substr(start, dot - start));
    start = dot + 1;
  }
  const std::string last = key.substr(start);
  toml::node& value = *parsed.get("value");
  if (toml::table* inner = node ? node->as_table() : nullptr) {
    inner->insert_or_assign(last, std::move(value));
    return;
  }
  toml::array* items = node ? node->as_array() : nullptr;
  const auto entry = items ? entry_of(*items, last) : std::nullopt;
  require(entry.has_value(), "{}: the case has no such key", source);
  items->replace(items->begin() + static_cast<std::ptrdiff_t>(*entry), std::move(value));
}

}  // namespace cosurge
