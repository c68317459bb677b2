#include "common/wire/parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "common/error.hpp"
#include "common/wire/convert.hpp"

namespace cosurge {
namespace {

using ::testing::ThrowsMessage;

TEST(StateParts, TogetherAreTheState) {
  for (const std::size_t length : {0U, 1U, 9U, 10U, 11U, 30U, 31U}) {
    std::string state(length, '\0');
    std::iota(state.begin(), state.end(), '\0');
    StateParts parts(state, 10);
    std::string together;
    std::size_t count = 0;
    bool last = false;
    while (!last) {
      v1::Saved message;
      last = parts.next(message);
      EXPECT_EQ(message.more(), !last);
      EXPECT_LE(message.state().size(), 10U);
      together += message.state();
      ++count;
    }
    EXPECT_EQ(together, state);
    EXPECT_EQ(count, std::max<std::size_t>(1, (length + 9) / 10));
  }
}

TEST(FrameParts, TogetherAreTheFrame) {
  Snapshot frame = {{.name = "position", .unit = "m", .components = 3, .values = std::vector<float>(300)},
                    {.name = "pressure", .unit = "Pa", .components = 1, .values = std::vector<float>(100)},
                    {.name = "none", .unit = "-", .components = 2, .values = {}}};
  for (Array& array : frame) std::iota(array.values.begin(), array.values.end(), 0.0F);
  for (const std::size_t bytes : {1U, 4U, 100U, 400U, 1200U, 1600U, 100000U}) {
    FrameParts parts(frame, bytes);
    Snapshot together;
    bool last = false;
    while (!last) {
      v1::Snapshot message;
      last = parts.next(message);
      EXPECT_EQ(message.more(), !last);
      append(decode(message), together);  // which requires whole particles
    }
    ASSERT_EQ(together.size(), frame.size()) << bytes;
    for (std::size_t k = 0; k < frame.size(); ++k) {
      EXPECT_EQ(together[k].name, frame[k].name);
      EXPECT_EQ(together[k].values, frame[k].values) << bytes;
    }
  }
}

TEST(FrameParts, AnArrayDoesNotChangeItsUnit) {
  Snapshot frame = {{.name = "position", .unit = "m", .components = 1, .values = {1}}};
  EXPECT_THAT([&] { append({{.name = "position", .unit = "mm", .components = 1, .values = {2}}}, frame); },
              ThrowsMessage<Error>(
                  "array position of a frame goes on with 1 components in \"mm\" instead of 1 in \"m\""));
}

TEST(Parts, MustEndAndFitTheParticles) {
  EXPECT_NO_THROW(require_part({.what = "state", .bytes = 0, .before = 0, .more = false}, 0));
  EXPECT_THAT([] { require_part({.what = "state", .bytes = 0, .before = 5, .more = true}, 10); },
              ThrowsMessage<Error>("it sends an empty part of a state, and says that more will follow"));
  const std::size_t most = (std::size_t{1} << 28) + 40960;
  EXPECT_NO_THROW(require_part({.what = "frame", .bytes = 60, .before = most - 60, .more = false}, 10));
  EXPECT_THAT([&] { require_part({.what = "frame", .bytes = 61, .before = most - 60, .more = true}, 10); },
              ThrowsMessage<Error>("its frame exceeds 268476416 bytes, the limit for 10 particles"));
}

}  // namespace
}  // namespace cosurge
