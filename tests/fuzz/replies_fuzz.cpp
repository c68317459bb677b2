// Any bytes instead of one reply of a legal run: accepted with finite numbers, or rejected with a message.
#include <cstdlib>

#include "common/wire/remote_participant.hpp"
#include "common/wire/serve.hpp"
#include "tests/fuzz/legal_seed.hpp"
#include "tests/support/requests.hpp"

namespace cosurge {
namespace {

const std::string token = "token";
const testing::Piston piston;

std::vector<std::string> legal_replies() {
  const auto fluid = testing::water_column(piston);
  Service service(*fluid, token);
  std::vector<v1::Request> requests = {
      testing::welcome_request(token), testing::initialize_request(2),
      testing::advance_request(3, InterfaceMotion::at_rest(2, piston.points))};
  for (std::uint64_t sequence = 4; sequence <= 5; ++sequence) requests.emplace_back().set_sequence(sequence);
  requests[3].mutable_save();
  requests[4].mutable_frame();
  std::vector<std::string> replies = {service.hello().SerializeAsString()};
  for (const v1::Request& request : requests) replies.push_back(service.answer(request).SerializeAsString());
  return replies;
}

void run_with(const std::string& bytes, std::size_t broken) {
  static const std::vector<std::string> run = legal_replies();
  auto [coupler, solver] = Channel::pair({.peer = "solver", .patience = 0}, {.peer = "coupler"});
  for (std::size_t k = 0; k < run.size(); ++k) solver.send_bytes(k == broken % run.size() ? bytes : run[k]);
  RemoteFluid fluid(std::move(coupler),
                    {.role = Role::fluid, .token = token, .dimension = 2, .capabilities = {}});
  Interface interface;
  InterfaceMotion motion;
  InterfaceLoad load;
  fluid.initialize(testing::piston_case(), interface, load);
  motion = InterfaceMotion::at_rest(2, interface.points());
  fluid.advance({.index = 0, .start = 0, .size = 1e-4}, motion, load);
  if (!load.force.allFinite() || !load.pressure.allFinite()) std::abort();
  fluid.save();
  fluid.frame();
}

}  // namespace
}  // namespace cosurge

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  static const std::vector<std::string> legal = cosurge::legal_replies();
  return cosurge::testing::legal_or_mutated(legal, data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cosurge::testing::run_one(data, size, cosurge::run_with);
}
