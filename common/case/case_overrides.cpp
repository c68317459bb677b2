#include "common/case/case_overrides.hpp"

#include <google/protobuf/message.h>

#include <optional>

#include "common/case/toml_bounds.hpp"
#include "common/error.hpp"
#include "proto/case.pb.h"

namespace cosurge {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// The value of an override: TOML, or a bare word.
toml::table parse_value(const std::string& source, const std::string& value) {
  try {
    require_ascii(value, source);
    return toml::parse("value = " + value, source);
  } catch (const std::runtime_error&) {  // require_ascii() and toml::parse()
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
  const bool removed = text.substr(equals + 1) == "none";
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
    if (removed)
      inner->erase(last);
    else
      inner->insert_or_assign(last, std::move(value));
    return;
  }
  toml::array* items = node ? node->as_array() : nullptr;
  const auto entry = items ? entry_of(*items, last) : std::nullopt;
  require(entry.has_value(), "{}: the case has no such key", source);
  require(!removed, "{}: none removes a key, not an entry of a list", source);
  items->replace(items->begin() + static_cast<std::ptrdiff_t>(*entry), std::move(value));
}

namespace {

/// The value of a field, or one entry of a repeated field, whose type is not a table.
template <typename Insert>
void insert_value(const Message& message, const FieldDescriptor& field, int entry, const Insert& insert) {
  const auto& r = *message.GetReflection();
  const bool listed = entry >= 0;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return insert(listed ? r.GetRepeatedDouble(message, &field, entry) : r.GetDouble(message, &field));
    case FieldDescriptor::CPPTYPE_INT32:
      return insert(
          std::int64_t{listed ? r.GetRepeatedInt32(message, &field, entry) : r.GetInt32(message, &field)});
    case FieldDescriptor::CPPTYPE_BOOL:
      return insert(listed ? r.GetRepeatedBool(message, &field, entry) : r.GetBool(message, &field));
    case FieldDescriptor::CPPTYPE_STRING:
      return insert(listed ? r.GetRepeatedString(message, &field, entry) : r.GetString(message, &field));
    case FieldDescriptor::CPPTYPE_ENUM:
      return insert(listed ? r.GetRepeatedEnum(message, &field, entry)->name()
                           : r.GetEnum(message, &field)->name());
    default:
      throw std::logic_error("case.proto: no writer for the type of " + field.full_name());
  }
}

}  // namespace

toml::table tree_of(const Message& message) {
  toml::table table;
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const v1::Rule& rule = field->options().GetExtension(v1::rule);
    if (rule.created()) continue;
    const bool tables = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (!field->is_repeated()) {
      if (tables)
        table.insert(field->name(), tree_of(reflection.GetMessage(message, field)));
      else
        insert_value(message, *field, -1, [&](auto value) { table.insert(field->name(), value); });
      continue;
    }
    toml::array items;
    for (int k = 0; k < reflection.FieldSize(message, field); ++k) {
      if (tables)
        items.push_back(tree_of(reflection.GetRepeatedMessage(message, field, k)));
      else
        insert_value(message, *field, k, [&](auto value) { items.push_back(value); });
    }
    table.insert_or_assign(rule.has_key() ? rule.key() : field->name(), std::move(items));
  }
  return table;
}

}  // namespace cosurge
