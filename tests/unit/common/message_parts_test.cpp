#include "common/wire/message_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "common/error.hpp"
#include "common/wire/channel.hpp"
#include "common/wire/convert.hpp"
#include "common/wire/wire_words.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void check(const std::string& bytes) { require_few_parts(bytes, *v1::Reply::descriptor()); }

/// `count` times the same bytes.
std::string times(std::size_t count, const std::string& bytes) {
  std::string all;
  all.reserve(count * bytes.size());
  for (std::size_t k = 0; k < count; ++k) all += bytes;
  return all;
}

/// A field of a length of three bytes and more.
std::string field(char tag, const std::string& content) {
  std::string length;
  std::size_t rest = content.size();
  for (; rest >= 0x80; rest >>= 7U) length += static_cast<char>((rest & 0x7fU) | 0x80U);
  length += static_cast<char>(rest);
  return tag + length + content;
}

TEST(MessageParts, AreCountedBeforeTheyTakeMemory) {
  const std::size_t many = most_parts + 1;
  const auto refused = ThrowsMessage<Error>(HasSubstr("more than 1000000 parts"));
  const std::string bombs[] = {
      field('\x1a', times(many, std::string("\x1a\0", 2))),  // Initialized.columns, empty
      field('\x22', times(many, std::string("\x2a\0", 2))),  // Advanced.notes, empty
      field('\x32', times(many, std::string("\x0a\0", 2))),  // Snapshot.arrays, empty
      times(many, std::string("\x78\x01", 2)),               // a field 15 that is not known
  };
  for (const std::string& bomb : bombs) EXPECT_THAT([&] { check(bomb); }, refused);
}

TEST(MessageParts, OfHonestMessagesAreFew) {
  v1::Reply reply;
  reply.set_sequence(7);
  reply.set_seconds(0.5);
  for (int k = 0; k < 300000; ++k) reply.mutable_advanced()->mutable_load()->add_force(k);
  for (int k = 0; k < 50; ++k) reply.mutable_advanced()->add_notes("a note");
  EXPECT_NO_THROW(check(reply.SerializeAsString()));
  EXPECT_NO_THROW(check(""));
}

TEST(MessageParts, OfAMessageThatIsCutOrNestedWithoutEndAreRefused) {
  v1::Reply reply;
  reply.mutable_saved()->set_state("the state");
  const std::string whole = reply.SerializeAsString();
  for (std::size_t length = 1; length < whole.size(); ++length)
    EXPECT_THAT([&] { check(whole.substr(0, length)); },
                ThrowsMessage<Error>(HasSubstr("cannot be decoded")));
}

TEST(MessageParts, AreAskedForByEveryChannel) {
  auto [first, second] = Channel::pair({.peer = "b"}, {.peer = "a"});
  second.send_bytes(field('\x22', times(most_parts + 1, std::string("\x2a\0", 2))));
  EXPECT_THAT(
      [&end = first] {
        v1::Reply reply;
        end.receive(reply, "an answer");
      },
      ThrowsMessage<Error>(HasSubstr("more than 1000000 parts")));
}

TEST(WireWords, HaveNoControlCharactersAndAnEnd) {
  EXPECT_EQ(printable("red \x1b[31m\a\n", 100), "red ?[31m?\n");
  EXPECT_EQ(printable("abcdef", 3), "abc...");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m is red to some terminals, \xc2\xb5 is not"),
            "?31m is red to some terminals, \xc2\xb5 is not");
  EXPECT_NO_THROW(require_name("tip_x", "a column"));
  for (const std::string& bad :
       {std::string(), std::string("a/b"), std::string(".."), std::string(101, 'x'), std::string("a\nb")})
    EXPECT_THROW(require_name(bad, "a column"), Error) << bad;
}

TEST(Modes, BeyondAThousandAreRefused) {
  v1::Motion motion;
  InterfaceMotion received = InterfaceMotion::at_rest(2, 0);
  for (int k = 0; k < 1001; ++k) motion.add_modes();
  EXPECT_THAT([&] { decode(motion, received); },
              ThrowsMessage<Error>(HasSubstr("1001 modes, must be <= 1000")));
}

}  // namespace
}  // namespace cosurge
