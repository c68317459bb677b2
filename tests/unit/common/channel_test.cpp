#include "common/wire/channel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "proto/exchange.pb.h"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

using std::chrono::steady_clock;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

double seconds_since(steady_clock::time_point start) {
  return std::chrono::duration<double>(steady_clock::now() - start).count();
}

v1::Request abort_request(const std::string& reason) {
  v1::Request request;
  request.mutable_abort()->set_reason(reason);
  return request;
}

/// Two ends over a transport, the first of which listens.
std::pair<Channel, Channel> connected(const std::string& endpoint, const Channel::Options& listens,
                                      const Channel::Options& connects) {
  Channel first = Channel::listen(endpoint, listens);
  Channel second =
      Channel::connect({.endpoint = first.endpoint(), .server_key = first.server_key()}, connects);
  return {std::move(first), std::move(second)};
}

void expect_passage_both_ways(Channel& first, Channel& second) {
  v1::Request received;
  second.send(abort_request("there"));
  first.receive(received, "a message");
  EXPECT_EQ(received.abort().reason(), "there");
  first.send(abort_request("and back"));
  second.receive(received, "a message");
  EXPECT_EQ(received.abort().reason(), "and back");
}

TEST(Channel, CarriesMessagesBothWaysWithinAProcessOverASocketFileAndOverTcp) {
  const testing::ScratchFolder folder;
  auto [first, second] = Channel::pair({.peer = "b"}, {.peer = "a"});
  expect_passage_both_ways(first, second);
  for (const std::string& endpoint :
       {"ipc://" + (folder.path() / "wire").string(), std::string("tcp://127.0.0.1:*")}) {
    auto [listens, connects] =
        connected(endpoint, {.peer = "b", .patience = 10}, {.peer = "a", .patience = 10});
    expect_passage_both_ways(listens, connects);
  }
}

TEST(Channel, CountsMessagesAndBytes) {
  auto [first, second] = Channel::pair({}, {});
  expect_passage_both_ways(first, second);
  EXPECT_EQ(first.traffic().messages, 2U);
  EXPECT_EQ(first.traffic().bytes_received, abort_request("there").ByteSizeLong());
  EXPECT_EQ(first.traffic().bytes_sent, abort_request("and back").ByteSizeLong());
}

TEST(Channel, DeliversTheLastMessageOfAnEndThatCloses) {
  const testing::ScratchFolder folder;
  const std::string endpoint = "ipc://" + (folder.path() / "wire").string();
  for (const bool within_process : {true, false}) {
    auto [first, second] = within_process ? Channel::pair({.peer = "b"}, {.peer = "a"})
                                          : connected(endpoint, {.peer = "b"}, {.peer = "a"});
    std::thread([closes = std::move(second)]() mutable {
      closes.send_last(abort_request("farewell"));
    }).join();
    v1::Request received;
    first.receive(received, "a message");
    EXPECT_EQ(received.abort().reason(), "farewell");
    EXPECT_THAT(
        [&end = first] {
          v1::Request next;
          end.receive(next, "one more");
        },
        ThrowsMessage<PeerLost>(AllOf(HasSubstr("b: "), HasSubstr("one more was awaited"))));
  }
}

TEST(Channel, NoticesWithinASecondOrTwoThatTheOtherEndHasClosed) {
  const testing::ScratchFolder folder;
  for (const std::string& endpoint :
       {"ipc://" + (folder.path() / "wire").string(), std::string("tcp://127.0.0.1:*")}) {
    auto [listens, connects] = connected(endpoint, {.peer = "the solver"}, {.peer = "the coupler"});
    expect_passage_both_ways(listens, connects);
    { const Channel closes = std::move(connects); }
    const auto start = steady_clock::now();
    EXPECT_THAT(
        [&end = listens] {
          v1::Request next;
          end.receive(next, "its answer");
        },
        ThrowsMessage<PeerLost>(AllOf(HasSubstr("the solver: the connection was lost"))));
    EXPECT_LT(seconds_since(start), 2);  // noticed at once; room for a busy machine
  }
}

TEST(Channel, GivesUpWhenPatienceIsOverAndSaysWhomItWaitedFor) {
  auto [first, second] = Channel::pair({.peer = "the fluid solver", .patience = 0.3}, {});
  const auto start = steady_clock::now();
  EXPECT_THAT(
      [&end = first] {
        v1::Request next;
        end.receive(next, "its answer to advance");
      },
      ThrowsMessage<PeerLost>(AllOf(HasSubstr("the fluid solver: no message within 0.3 s"),
                                    HasSubstr("its answer to advance was awaited"))));
  EXPECT_GE(seconds_since(start), 0.3);
  EXPECT_LT(seconds_since(start), 2);  // room for a busy machine
}

TEST(Channel, SleepsWhileItWaits) {
  auto [first, second] = Channel::pair({.patience = 0.5}, {});
  const std::clock_t before = std::clock();
  v1::Request next;
  EXPECT_THROW(first.receive(next, "nothing"), PeerLost);
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC,
            0.05);  // a tenth of a core; spinning takes 0.5
}

TEST(Channel, RefusesMessagesBeyondItsLimitAndWhatIsNoMessage) {
  auto [first, second] = Channel::pair({.peer = "b", .message_limit = 100}, {.peer = "a"});
  EXPECT_THAT([&end = first] { end.send(abort_request(std::string(200, 'x'))); },
              ThrowsMessage<Error>(HasSubstr("bytes to b exceeds the limit of 100")));
  second.send(abort_request(std::string(200, 'x')));
  EXPECT_THAT(
      [&end = first] {
        v1::Request next;
        end.receive(next, "a message");
      },
      ThrowsMessage<Error>(HasSubstr("exceeds the limit of 100")));
  second.send_bytes("\xff\xff\xff");
  EXPECT_THAT(
      [&end = first] {
        v1::Request next;
        end.receive(next, "a message");
      },
      ThrowsMessage<Error>(HasSubstr("3 bytes cannot be decoded")));
}

TEST(Channel, GoesOverTcpWithTheKeyOfTheRunOnly) {
  const Channel listens = Channel::listen("tcp://127.0.0.1:*", {.patience = 1});
  EXPECT_EQ(listens.server_key().size(), 40U);
  EXPECT_THAT([&] { Channel::connect({.endpoint = listens.endpoint()}, {}); },
              ThrowsMessage<Error>(HasSubstr("tcp:// needs the coupler's public key")));

  const std::string other_key = Channel::listen("tcp://127.0.0.1:*", {}).server_key();
  Channel stranger = Channel::connect({.endpoint = listens.endpoint(), .server_key = other_key},
                                      {.peer = "the coupler", .patience = 5});
  stranger.send(abort_request("let me in"));
  EXPECT_THAT(
      [&] {
        v1::Request next;
        stranger.receive(next, "a welcome");
      },
      ThrowsMessage<PeerLost>(HasSubstr("the coupler: ")));
}

TEST(Channel, LetsNoStrangerDisturbTheConnection) {
  Channel listens = Channel::listen("tcp://127.0.0.1:*", {.peer = "b", .patience = 10});
  const std::string other_key = Channel::listen("tcp://127.0.0.1:*", {}).server_key();
  const Channel stranger = Channel::connect({.endpoint = listens.endpoint(), .server_key = other_key}, {});
  Channel connects = Channel::connect({.endpoint = listens.endpoint(), .server_key = listens.server_key()},
                                      {.peer = "a", .patience = 10});
  expect_passage_both_ways(listens, connects);
  {
    const Channel second =
        Channel::connect({.endpoint = listens.endpoint(), .server_key = listens.server_key()}, {});
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    expect_passage_both_ways(listens, connects);
  }
  expect_passage_both_ways(listens, connects);
}

TEST(Channel, RefusesEndpointsThatCannotWork) {
  EXPECT_THAT([] { Channel::listen("inproc://x", {}); },
              ThrowsMessage<Error>(HasSubstr("must begin with ipc:// or tcp://")));
  EXPECT_THAT([] { Channel::listen("ipc:///tmp/" + std::string(120, 'x'), {}); },
              ThrowsMessage<Error>(HasSubstr("longer than the 107 characters")));
  EXPECT_THAT([] { Channel::listen("ipc:///nowhere/wire", {}); },
              ThrowsMessage<Error>(HasSubstr("cannot listen at ipc:///nowhere/wire: No such file")));
}

}  // namespace
}  // namespace cosurge
