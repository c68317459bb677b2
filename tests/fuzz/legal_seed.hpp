// Inputs of a fuzz target that are derived from valid ones: [number of the changed part, its bytes].
#pragma once

#include <google/protobuf/stubs/logging.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "common/error.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace cosurge::testing {

/// Result of libFuzzer's custom mutator: now and then a legal part, else a change of the present one.
inline std::size_t legal_or_mutated(const std::vector<std::string>& legal, std::uint8_t* data,
                                    std::size_t size, std::size_t most, unsigned seed) {
  constexpr unsigned rarely = 50;
  if (size > 1 && seed % rarely != 0) return 1 + LLVMFuzzerMutate(data + 1, size - 1, most - 1);
  const std::size_t part = seed / rarely % legal.size();
  if (legal[part].size() + 1 > most) return size;
  data[0] = static_cast<std::uint8_t>(part);
  std::memcpy(data + 1, legal[part].data(), legal[part].size());
  return legal[part].size() + 1;
}

/// What LLVMFuzzerTestOneInput does: runs with the bytes in place of the part; an exception with a message is
/// a correct reaction.
template <typename RunWith>
int run_one(const std::uint8_t* data, std::size_t size, const RunWith& run_with) {
  google::protobuf::SetLogHandler(nullptr);  // it reports every message that it cannot read
  if (size == 0) return 0;
  try {
    run_with(std::string(reinterpret_cast<const char*>(data + 1), size - 1), std::size_t{data[0]});
  } catch (const Error&) {
  } catch (const NumericalError&) {
  }
  return 0;
}

}  // namespace cosurge::testing
