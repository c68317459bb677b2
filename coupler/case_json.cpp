#include "coupler/case_json.hpp"

#include <google/protobuf/util/json_util.h>

#include "common/error.hpp"

namespace cosurge {

std::string as_json(const v1::Case& the_case) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = true;
  options.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(the_case, &json, options);
  require(status.ok(), "the case cannot be written as JSON: {}", status.ToString());
  return json;
}

}  // namespace cosurge
