#include "coupler/report/case_table.hpp"

#include <fmt/ranges.h>

#include "common/case/several_solids.hpp"

namespace cosurge {
namespace {

using Json = nlohmann::ordered_json;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

constexpr int most_shown = 8;  // numbers of a list

/// The text of value `k` of a list, or of a single value (-1).
std::string text_of(const Message& message, const FieldDescriptor* field, int k) {
  const Reflection* r = message.GetReflection();
  const bool one = k < 0;
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return fmt::format("{:g}",
                         one ? r->GetDouble(message, field) : r->GetRepeatedDouble(message, field, k));
    case FieldDescriptor::CPPTYPE_INT32:
      return fmt::format("{}", one ? r->GetInt32(message, field) : r->GetRepeatedInt32(message, field, k));
    case FieldDescriptor::CPPTYPE_UINT32:
      return fmt::format("{}", one ? r->GetUInt32(message, field) : r->GetRepeatedUInt32(message, field, k));
    case FieldDescriptor::CPPTYPE_BOOL:
      return (one ? r->GetBool(message, field) : r->GetRepeatedBool(message, field, k)) ? "true" : "false";
    case FieldDescriptor::CPPTYPE_ENUM:
      return (one ? r->GetEnum(message, field) : r->GetRepeatedEnum(message, field, k))->name();
    case FieldDescriptor::CPPTYPE_STRING:
      return one ? r->GetString(message, field) : r->GetRepeatedString(message, field, k);
    default:
      return "?";  // the schema has no other types
  }
}

std::string list_of(const Message& message, const FieldDescriptor* field) {
  const int size = message.GetReflection()->FieldSize(message, field);
  std::vector<std::string> texts;
  for (int k = 0; k < std::min(size, most_shown); ++k) texts.push_back(text_of(message, field, k));
  return fmt::format("{}{}", fmt::join(texts, ", "),
                     size > most_shown ? fmt::format(" ... ({} numbers)", size) : "");
}

void add(Json& rows, const std::string& prefix, const Message& message) {
  const Reflection* r = message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  r->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const v1::Rule& rule = field->options().GetExtension(v1::rule);
    if (rule.created()) continue;
    const std::string key = prefix + (rule.has_key() ? rule.key() : field->name());
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      if (!field->is_repeated()) add(rows, key + ".", r->GetMessage(message, field));
      for (int k = 0; field->is_repeated() && k < r->FieldSize(message, field); ++k)
        add(rows, fmt::format("{}.{}.", key, k), r->GetRepeatedMessage(message, field, k));
      continue;
    }
    const std::string value = field->is_repeated() ? list_of(message, field) : text_of(message, field, -1);
    rows.push_back({key, value, rule.unit() == "-" ? "" : rule.unit()});
  }
}

}  // namespace

Json case_table(const v1::Case& the_case) {
  Json rows = Json::array();
  v1::Case written = the_case;
  if (has_several_solids(the_case)) written.clear_solid();  // the bodies of all structures, which follow
  add(rows, "", written);
  return rows;
}

}  // namespace cosurge
