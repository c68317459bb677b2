// Arbitrary messages: neither side may crash or hang.
#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "common/wire/remote_participant.hpp"
#include "common/wire/serve.hpp"
#include "tests/support/mock_participant.hpp"
#include "tests/support/requests.hpp"

namespace cosurge {
namespace {

constexpr int rounds = 2000;
const std::string token = "token";
const testing::Piston piston;

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t bound) {
  return random() % bound;
}  // not std's: same on every platform

/// Random bytes, a message that is cut, or one with a few bytes changed.
std::string mutilated(const std::string& message, Random& random) {
  const std::size_t way = below(random, 3);
  if (way == 0) {
    std::string noise(below(random, 64), '\0');
    for (char& byte : noise) byte = static_cast<char>(below(random, 256));
    return noise;
  }
  std::string bytes = message;
  if (way == 1) return bytes.substr(0, below(random, bytes.size()));
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t k = 0; k < changes; ++k)
    bytes[below(random, bytes.size())] = static_cast<char>(below(random, 256));
  return bytes;
}

/// Counts how often `attempt` throws in all rounds, and watches the clock.
template <typename Attempt>
int count_refusals(Attempt&& attempt) {
  google::protobuf::SetLogHandler(nullptr);  // it reports every message that it cannot read
  Random random(20240601);
  const auto start = std::chrono::steady_clock::now();
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    try {
      attempt(random);
    } catch (const Error&) {
      ++refused;
    } catch (const NumericalError&) {
      ++refused;
    }
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));  // 1 s on an idle machine
  return refused;
}

TEST(Fuzz, NoRequestCrashesOrHangsASolver) {
  const std::vector<v1::Request> run = {
      testing::welcome_request(token), testing::initialize_request(2),
      testing::advance_request(3, InterfaceMotion::at_rest(2, piston.points))};
  const int refused = count_refusals([&](Random& random) {
    const auto fluid = testing::water_column(piston);
    auto [coupler, solver] = Channel::pair({.peer = "solver"}, {.peer = "coupler", .patience = 5});
    const std::size_t broken = below(random, run.size());
    for (std::size_t k = 0; k < broken; ++k) coupler.send(run[k]);
    coupler.send_bytes(mutilated(run[broken].SerializeAsString(), random));
    v1::Request abort;
    abort.mutable_abort();
    coupler.send(abort);  // where the broken request was taken for a right one
    serve(*fluid, solver, token);
  });
  EXPECT_EQ(refused, rounds);  // with an error or by the abort
}

/// The replies of a legal run to welcome, initialize and advance.
std::vector<v1::Reply> legal_replies() {
  const auto fluid = testing::water_column(piston);
  Service service(*fluid, token);
  std::vector<v1::Reply> replies = {service.hello()};
  replies.push_back(service.answer(testing::welcome_request(token)));
  replies.push_back(service.answer(testing::initialize_request(2)));
  replies.push_back(service.answer(testing::advance_request(3, InterfaceMotion::at_rest(2, piston.points))));
  return replies;
}

TEST(Fuzz, NoReplyCrashesOrHangsTheCoupler) {
  const std::vector<v1::Reply> run = legal_replies();
  const int refused = count_refusals([&](Random& random) {
    auto [coupler, solver] = Channel::pair({.peer = "solver", .patience = 5}, {.peer = "coupler"});
    const std::size_t broken = below(random, run.size());
    for (std::size_t k = 0; k < run.size(); ++k) {
      k == broken ? solver.send_bytes(mutilated(run[k].SerializeAsString(), random)) : solver.send(run[k]);
    }
    RemoteFluid fluid(std::move(coupler),
                      {.role = Role::fluid, .token = token, .dimension = 2, .capabilities = {}});
    Interface interface;
    InterfaceMotion motion;
    InterfaceLoad load;
    fluid.initialize(testing::piston_case(), interface, load);
    motion = InterfaceMotion::at_rest(2, interface.points());
    fluid.advance({.index = 0, .start = 0, .size = 1e-4}, motion, load);
    ASSERT_TRUE(load.force.allFinite());
  });
  // A changed byte may fall into a number or a name and leave a right message; a third of the rounds changes
  // bytes.
  EXPECT_GT(refused, rounds / 2);
}

}  // namespace
}  // namespace cosurge
