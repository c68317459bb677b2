// Any bytes instead of one request of a legal run: answered, or rejected with a message.
#include "common/wire/message_parts.hpp"
#include "common/wire/serve.hpp"
#include "tests/fuzz/legal_seed.hpp"
#include "tests/support/requests.hpp"

namespace cosurge {
namespace {

const std::string token = "token";
const testing::Piston piston;

std::vector<v1::Request> legal_requests() {
  std::vector<v1::Request> run = {testing::welcome_request(token), testing::initialize_request(2),
                                  testing::advance_request(3, InterfaceMotion::at_rest(2, piston.points))};
  for (std::uint64_t sequence = 4; sequence <= 7; ++sequence) run.emplace_back().set_sequence(sequence);
  run[3].mutable_save();
  run[4].mutable_frame();
  run[5].mutable_restore()->set_state(std::string(sizeof(double), '\0'));
  run[6].mutable_finalize();
  return run;
}

void run_with(const std::string& bytes, std::size_t broken) {
  static const std::vector<v1::Request> run = legal_requests();
  const auto fluid = testing::water_column(piston);
  Service service(*fluid, token);
  for (std::size_t k = 0; k < run.size(); ++k) {
    v1::Request request = run[k];
    if (k == broken % run.size()) {
      require_few_parts(bytes, *v1::Request::descriptor());
      if (!request.ParseFromString(bytes)) return;
    }
    service.answer(request).SerializeAsString();
  }
}

}  // namespace
}  // namespace cosurge

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  static const std::vector<std::string> legal = [] {
    std::vector<std::string> bytes;
    for (const auto& request : cosurge::legal_requests()) bytes.push_back(request.SerializeAsString());
    return bytes;
  }();
  return cosurge::testing::legal_or_mutated(legal, data, size, most, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return cosurge::testing::run_one(data, size, cosurge::run_with);
}
