#include "common/wire/message_parts.hpp"

#include <google/protobuf/io/coded_stream.h>

#include <cstdint>

#include "common/error.hpp"

namespace cosurge {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::io::CodedInputStream;

constexpr int deepest = 32;

/// Goes through the fields of the wire format, and counts.
class Walk {
 public:
  explicit Walk(CodedInputStream& in) : in_(in) {}

  /// False where the message is malformed.
  bool message(const Descriptor& type, int depth) {
    if (depth > deepest) return false;
    while (const std::uint32_t tag = in_.ReadTag()) {
      constexpr std::uint32_t bits_of_wire_type = 3;
      const FieldDescriptor* field = type.FindFieldByNumber(static_cast<int>(tag >> bits_of_wire_type));
      if (!value(tag & 7U, field, depth)) return false;
    }
    return depth == 0 ? in_.ConsumedEntireMessage() : in_.BytesUntilLimit() == 0;
  }

 private:
  bool value(std::uint32_t wire_type, const FieldDescriptor* field, int depth) {
    std::uint64_t number = 0;
    std::uint32_t short_number = 0;
    if (field == nullptr) count();
    if (wire_type == 0) return in_.ReadVarint64(&number);
    if (wire_type == 1) return in_.ReadLittleEndian64(&number);
    if (wire_type == 5) return in_.ReadLittleEndian32(&short_number);
    if (wire_type != 2 || !in_.ReadVarint32(&short_number)) return false;
    const int length = static_cast<int>(short_number);
    if (const int rest = in_.BytesUntilLimit(); length < 0 || (rest >= 0 && length > rest)) return false;
    const bool nested = field != nullptr && field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (nested || (field != nullptr && field->cpp_type() == FieldDescriptor::CPPTYPE_STRING)) count();
    if (!nested) return in_.Skip(length);
    const auto limit = in_.PushLimit(length);
    if (!message(*field->message_type(), depth + 1)) return false;
    in_.PopLimit(limit);
    return true;
  }

  void count() {
    require(++parts_ <= most_parts, "a message has more than {} parts (texts, tables, unknown fields)",
            most_parts);
  }

  CodedInputStream& in_;
  std::size_t parts_ = 0;
};

}  // namespace

void require_few_parts(std::string_view bytes, const Descriptor& type) {
  CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size()));
  require(Walk(in).message(type, 0),
          "a message of {} bytes cannot be decoded: it is damaged, truncated or from another program",
          bytes.size());
}

}  // namespace cosurge
