#include "common/case/case_file.hpp"

#include <cmath>
#include <filesystem>
#include <optional>

#include "common/case/case_overrides.hpp"
#include "common/case/case_rules.hpp"
#include "common/case/case_tables.hpp"
#include "common/case/case_text.hpp"
#include "common/case/several_solids.hpp"
#include "common/case/snap_probes.hpp"
#include "common/case/toml.hpp"
#include "common/error.hpp"

namespace cosurge {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Where a node stands; `around` for a table that an override has brought about, which stands nowhere.
std::string place(const toml::node& node, const std::string& around) {
  const toml::source_region& source = node.source();
  if (!source.path) return around;
  const std::string& path = *source.path;
  return path.starts_with("--set") ? path : fmt::format("{}:{}", path, source.begin.line);
}

std::string child(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

const v1::Rule& rule_of(const FieldDescriptor& field) { return field.options().GetExtension(v1::rule); }

/// Whether a field is a key of the case file by its own name.
bool is_key(const FieldDescriptor& field) { return !rule_of(field).has_key() && !rule_of(field).created(); }

/// The field of a key; null if there is none. A list of tables may have another field than one table.
const FieldDescriptor* field_of(const Descriptor& type, const std::string& key, const toml::node& node) {
  const FieldDescriptor* field = type.FindFieldByName(key);
  if (field == nullptr || !is_key(*field)) return nullptr;
  for (int i = 0; node.is_array() && !field->is_repeated() && i < type.field_count(); ++i)
    if (rule_of(*type.field(i)).key() == key) return type.field(i);
  return field;
}

std::string field_names(const Descriptor& type) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(type.field_count()));
  for (int i = 0; i < type.field_count(); ++i)
    if (is_key(*type.field(i))) names.push_back(type.field(i)->name());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string words(const EnumDescriptor& type) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(type.value_count()));
  for (int i = 0; i < type.value_count(); ++i) names.push_back(type.value(i)->name());
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Whether a number is the same as a double. (toml++ makes garbage of a whole number where it is not.)
bool is_exact(const toml::node& node) {
  if (!node.is_integer()) return true;
  constexpr double end = 9223372036854775808.0;  // 2^63, behind the largest
  const std::int64_t value = node.as_integer()->get();
  const auto nearest = static_cast<double>(value);
  return nearest < end && static_cast<std::int64_t>(nearest) == value;
}

/// One walk over a TOML tree and a message descriptor together; collects every error.
class Walk {
 public:
  explicit Walk(CaseErrors& errors) : errors_(errors) {}

  void table(const toml::table& from, const std::string& path, Message& into) {
    const std::string here = errors_.places[path] = place(from, errors_.places[path]);
    const Descriptor& type = *into.GetDescriptor();
    for (const auto& [key, node] : from) {
      const FieldDescriptor* field = field_of(type, std::string(key.str()), node);
      const std::string key_path = child(path, key.str());
      if (field != nullptr || errors_.lines.size() < CaseErrors::most)
        errors_.places[key_path] = place(node, here);
      if (field == nullptr) {
        errors_.add(key_path, "unknown key, allowed: " + field_names(type));
      } else if (field->is_repeated()) {
        list(node, key_path, *field, into);
      } else {
        single(node, key_path, *field, into);
      }
    }
    for (int i = 0; i < type.field_count(); ++i) {
      const FieldDescriptor& field = *type.field(i);
      const v1::Rule& rule = rule_of(field);
      const bool needed = field.is_required() || (rule.vector() && !rule.may_miss()) || rule.at_least() > 0;
      if (needed && !from.contains(field.name())) {
        errors_.places[child(path, field.name())] = here;
        errors_.add(child(path, field.name()), "missing");
      }
    }
  }

 private:
  void single(const toml::node& node, const std::string& path, const FieldDescriptor& field, Message& into) {
    const auto& reflection = *into.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_MESSAGE:
        if (const toml::table* inner = node.as_table())
          return table(*inner, path, *reflection.MutableMessage(&into, &field));
        return errors_.add(path, "must be a table, allowed keys: " + field_names(*field.message_type()));
      case FieldDescriptor::CPPTYPE_DOUBLE:
        if (const auto value = number(node, path, field)) reflection.SetDouble(&into, &field, *value);
        return;
      case FieldDescriptor::CPPTYPE_INT32:
        if (!node.is_integer()) return errors_.add(path, "must be a whole number");
        if (const std::int64_t value = node.as_integer()->get(); value != static_cast<std::int32_t>(value))
          return errors_.add(
              path, fmt::format("{} must be {}", value, value > 0 ? "<= 2147483647" : ">= -2147483648"));
        if (const auto value = number(node, path, field))
          reflection.SetInt32(&into, &field, static_cast<int>(*value));
        return;
      case FieldDescriptor::CPPTYPE_BOOL:
        if (!node.is_boolean()) return errors_.add(path, "must be true or false");
        return reflection.SetBool(&into, &field, *node.value<bool>());
      case FieldDescriptor::CPPTYPE_STRING:
        if (!node.is_string()) return errors_.add(path, "must be a text in quotes");
        return reflection.SetString(&into, &field, *node.value<std::string>());
      case FieldDescriptor::CPPTYPE_ENUM:
        return choice(node, path, field, into);
      default:
        throw std::logic_error("case.proto: no reader for the type of " + field.full_name());
    }
  }

  void choice(const toml::node& node, const std::string& path, const FieldDescriptor& field, Message& into) {
    const EnumDescriptor& type = *field.enum_type();
    const auto* value = node.is_string() ? type.FindValueByName(*node.value<std::string>()) : nullptr;
    if (value == nullptr) return errors_.add(path, "must be one of: " + words(type));
    if (field.is_repeated()) return into.GetReflection()->AddEnum(&into, &field, value);
    into.GetReflection()->SetEnum(&into, &field, value);
  }

  void list(const toml::node& node, const std::string& path, const FieldDescriptor& field, Message& into) {
    const bool tables = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    const v1::Rule& rule = rule_of(field);
    const toml::array* array = node.as_array();
    if (array == nullptr) return errors_.add(path, tables ? "must be a list of tables" : "must be a list");
    if (rule.vector() && static_cast<int>(array->size()) != errors_.dimension)
      errors_.add(path, fmt::format("has {} components, must have {}", array->size(), errors_.dimension));
    if (rule.has_key() && array->empty()) errors_.add(path, "has no entries");
    if (array->size() < rule.at_least())
      errors_.add(path, fmt::format("has {} entries, needs at least {}", array->size(), rule.at_least()));
    int entry = 0;
    for (const toml::node& item : *array) {
      const std::string item_path = fmt::format("{}.{}", path, entry++);
      errors_.places[item_path] = place(item, errors_.places[path]);
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM) {
        choice(item, item_path, field, into);
      } else if (!tables) {
        if (const auto value = number(item, item_path, field))
          into.GetReflection()->AddDouble(&into, &field, *value);
      } else if (const toml::table* inner = item.as_table()) {
        table(*inner, item_path, *into.GetReflection()->AddMessage(&into, &field));
      } else {
        errors_.add(item_path, "must be a table");
      }
    }
  }

  std::optional<double> number(const toml::node& node, const std::string& path,
                               const FieldDescriptor& field) {
    if (!node.is_number()) {
      errors_.add(path, "must be a number");
      return std::nullopt;
    }
    if (!is_exact(node)) {
      errors_.add(
          path,
          fmt::format(
              "{} is a whole number that a double cannot store exactly; write {}.0 to use the nearest double",
              node.as_integer()->get(), node.as_integer()->get()));
      return std::nullopt;
    }
    const double value =
        node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
    const v1::Rule& rule = rule_of(field);
    const std::string unit = rule.has_unit() ? fmt::format(" [{}]", rule.unit()) : "";
    const auto bound = [&](bool ok, const char* relation, double limit) {
      if (!ok) errors_.add(path, fmt::format("{} must be {} {}{}", value, relation, limit, unit));
    };
    if (!std::isfinite(value)) {
      errors_.add(path, fmt::format("{} must be finite{}", value, unit));
      return std::nullopt;
    }
    if (rule.has_gt()) bound(value > rule.gt(), ">", rule.gt());
    if (rule.has_ge()) bound(value >= rule.ge(), ">=", rule.ge());
    if (rule.has_lt()) bound(value < rule.lt(), "<", rule.lt());
    if (rule.has_le()) bound(value <= rule.le(), "<=", rule.le());
    return value;
  }

  CaseErrors& errors_;
};

/// Writes every default into the message, so that the results contain the whole case.
void resolve(Message& message) {
  const Descriptor& type = *message.GetDescriptor();
  const auto& reflection = *message.GetReflection();
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    const bool is_message = field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (field.is_repeated()) {
      for (int k = 0; is_message && k < reflection.FieldSize(message, &field); ++k)
        resolve(*reflection.MutableRepeatedMessage(&message, &field, k));
    } else if (is_message) {
      const bool part = &type == v1::Case::descriptor();  // an absent part of the scene does not exist
      const bool absence_counts = part || rule_of(field).may_miss();
      const bool given = reflection.HasField(message, &field);
      if (!given && absence_counts) continue;
      Message& inner = *reflection.MutableMessage(&message, &field);
      resolve(inner);
      if (!given && inner.ByteSizeLong() == 0) reflection.ClearField(&message, &field);  // it has no defaults
    } else if (field.has_default_value() && !reflection.HasField(message, &field)) {
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE)
        reflection.SetDouble(&message, &field, field.default_value_double());
      else if (field.cpp_type() == FieldDescriptor::CPPTYPE_INT32)
        reflection.SetInt32(&message, &field, field.default_value_int32());
      else if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM)
        reflection.SetEnum(&message, &field, field.default_value_enum());
      else
        throw std::logic_error("case.proto: no default for the type of " + field.full_name());
    }
  }
}

/// `name`: of the case file in errors.
v1::Case checked_case(toml::table root, const std::vector<std::string>& overrides, const std::string& name,
                      const std::filesystem::path& folder) {
  for (const std::string& text : overrides) apply_override(root, text);
  require_known_schema(root);

  v1::Case result;
  CaseErrors errors;
  errors.dimension = static_cast<int>(root["dimension"].value_or<std::int64_t>(result.dimension()));
  Walk(errors).table(root, "", result);
  errors.places[""] = name;
  errors.raise();
  const bool has_solid = result.has_solid() || result.solids_size() > 0;
  if (result.has_fluid() && has_solid) result.mutable_coupling();
  result.mutable_output();
  read_tables(result, folder, errors);
  errors.raise();
  resolve(result);
  join_solids(result);
  snap_probes(result);
  check_rules(result, errors);
  errors.raise();
  return result;
}

}  // namespace

v1::Case load_case(const std::string& path, const std::vector<std::string>& overrides) {
  std::filesystem::path file = path;
  std::error_code cause;
  if (std::filesystem::is_directory(file, cause)) file /= "case.toml";
  const bool there = std::filesystem::is_regular_file(file, cause);
  require(there, "{}: no such case{}", file.string(), cause ? ": " + cause.message() : "");
  return checked_case(case_tree(case_text(file), file.string()), overrides, file.string(),
                      file.parent_path());
}

v1::Case read_case(const std::string& text, const std::vector<std::string>& overrides,
                   const std::filesystem::path& folder) {
  constexpr const char* name = "case";
  return checked_case(case_tree(text, name), overrides, name, folder);
}

v1::Case change_case(const v1::Case& the_case, const std::vector<std::string>& overrides) {
  toml::table root = tree_of(the_case);
  for (const std::string& text : overrides) apply_override(root, text);
  v1::Case result;
  CaseErrors errors;
  errors.dimension = the_case.dimension();
  errors.places[""] = "--set";
  Walk(errors).table(root, "", result);
  errors.raise();
  resolve(result);
  join_solids(result);
  check_rules(result, errors);
  errors.raise();
  return result;
}

}  // namespace cosurge
