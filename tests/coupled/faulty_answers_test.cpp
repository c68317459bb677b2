// Faults that any answer of a solver may have, at every phase of the protocol.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/scripted_solver.hpp"

namespace cosurge::testing {
namespace {

const std::string token = "token of the run";

/// Name of a phase in messages, and of its answer.
struct Names {
  const char* call;
  const char* answer;
};

constexpr Names names[phases] = {{"", "hello"},
                                 {"welcome", "done"},
                                 {"initialize", "initialized"},
                                 {"advance, window 0 (t = 0 s)", "advanced"},
                                 {"save", "saved"},
                                 {"frame", "snapshot"},
                                 {"restore", "done"},
                                 {"finalize", "done"}};

class AnyAnswer : public ::testing::TestWithParam<int> {
 protected:
  Phase phase() const { return static_cast<Phase>(GetParam()); }
  bool is_hello() const { return phase() == Phase::hello; }
  const Names& name() const { return names[GetParam()]; }

  /// The message of the coupler about this phase.
  std::string about(const std::string& what) const {
    if (is_hello()) return "the solid solver: refused: " + what;
    return fmt::format("mock_solid 0.1.0: {} [{}]", what, name().call);
  }

  std::string error(const std::function<void(v1::Reply&)>& spoil) const {
    return error_of_coupler(Role::solid, phase(), spoil);
  }

  /// The error where these bytes come in place of the answer.
  std::string error_of_bytes(const std::function<std::string(const std::string&)>& change) const {
    std::vector<std::string> bytes;
    for (const v1::Reply& answer : right_answers(Role::solid, token))
      bytes.push_back(answer.SerializeAsString());
    std::string& wrong = bytes[static_cast<std::size_t>(GetParam())];
    wrong = change(wrong);
    return error_of_coupler(Role::solid, token, bytes);
  }
};

TEST_P(AnyAnswer, OfARightSolverIsAccepted) {
  EXPECT_EQ(error([](v1::Reply&) {}), "");
}

TEST_P(AnyAnswer, WithoutAResultIsNamed) {
  const auto expected = is_hello()
                            ? about("its first message is not a hello")
                            : about(fmt::format("it answers with no result instead of {}", name().answer));
  EXPECT_EQ(error([](v1::Reply& reply) { reply.clear_result(); }), expected);
}

TEST_P(AnyAnswer, ToAnotherRequestIsNamed) {
  const bool saved = phase() == Phase::save;
  const auto expected = is_hello() ? about("its first message is not a hello")
                                   : about(fmt::format("it answers with {} instead of {}",
                                                       saved ? "snapshot" : "saved", name().answer));
  EXPECT_EQ(
      error([&](v1::Reply& reply) { saved ? (void)reply.mutable_snapshot() : (void)reply.mutable_saved(); }),
      expected);
}

TEST_P(AnyAnswer, WithAnotherNumberIsNamed) {
  const auto expected =
      is_hello() ? about("its first message is not a hello")
                 : about(fmt::format("its answer has number {} instead of {}", GetParam() + 5, GetParam()));
  EXPECT_EQ(error([](v1::Reply& reply) { reply.set_sequence(reply.sequence() + 5); }), expected);
}

/// All but the hello, which says no time.
class TimedAnswer : public AnyAnswer {};

TEST_P(TimedAnswer, ThatSaysAnImpossibleTimeIsNamed) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error([](v1::Reply& reply) { reply.set_seconds(-1); }), about("it says it computed for -1 s"));
  EXPECT_EQ(error([](v1::Reply& reply) { reply.set_seconds(infinite); }),
            about("it says it computed for inf s"));
}

TEST_P(AnyAnswer, ThatIsAFailureEndsTheRunWithItsWords) {
  const auto expected = is_hello() ? about("out of licences") : "mock_solid 0.1.0: out of licences";
  EXPECT_EQ(error([](v1::Reply& reply) { reply.mutable_failure()->set_what("out of licences"); }), expected);
}

TEST_P(AnyAnswer, OfBytesThatAreNoMessageIsNamed) {
  const auto damaged = [this](std::size_t size) {
    return about(fmt::format(
        "a message of {} bytes cannot be decoded: it is damaged, truncated or from another program", size));
  };
  EXPECT_EQ(error_of_bytes([](const std::string&) { return "\xde\xad\xbe\xef"; }), damaged(4));
  std::size_t size = 0;
  const std::string cut = error_of_bytes([&](const std::string& bytes) {
    size = bytes.size() - 1;
    return bytes.substr(0, size);
  });
  EXPECT_EQ(cut, damaged(size));
}

TEST_P(AnyAnswer, ThatIsTooLargeIsNamed) {
  const std::string unknown = "\xf8\x07\x01";  // a field that the schema does not have
  std::string many;
  for (int k = 0; k < 333333; ++k) many += unknown;
  const bool has_numbers = !is_hello() && std::string(name().answer) != "done";
  std::size_t size = 0;
  const std::string large = error_of_bytes([&](const std::string& bytes) {
    size = bytes.size() + many.size();
    return bytes + many;
  });
  EXPECT_EQ(large, about(fmt::format("a message of {} bytes exceeds the limit of {}", size,
                                     has_numbers ? 1000000 : 65536)));
}

std::string name_of(const ::testing::TestParamInfo<int>& test) {
  const std::string call = names[test.param].call;
  return test.param == 0 ? std::string("hello") : call.substr(0, call.find(','));
}

INSTANTIATE_TEST_SUITE_P(Protocol, AnyAnswer, ::testing::Range(0, static_cast<int>(phases)), name_of);
INSTANTIATE_TEST_SUITE_P(Protocol, TimedAnswer, ::testing::Range(1, static_cast<int>(phases)), name_of);

}  // namespace
}  // namespace cosurge::testing
