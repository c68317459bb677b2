#include "common/wire/connection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/error.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(ConnectionFile, ComesBackAsWritten) {
  const testing::ScratchFolder folder;
  const Connection written{
      .role = Role::solid, .endpoint = "tcp://127.0.0.1:5555", .token = new_token(), .server_key = "key"};
  write_connection(written, folder.path() / "solid.connection");
  const Connection read = read_connection(folder.path() / "solid.connection");
  EXPECT_EQ(read.role, written.role);
  EXPECT_EQ(read.endpoint, written.endpoint);
  EXPECT_EQ(read.token, written.token);
  EXPECT_EQ(read.server_key, written.server_key);
}

TEST(ConnectionFile, CanBeReadByItsOwnerOnlyEvenWhereItReplacesAnotherFile) {
  const testing::ScratchFolder folder;
  const auto path = folder.path() / "fluid.connection";
  std::ofstream(path) << "open to all";
  std::filesystem::permissions(path, std::filesystem::perms::all);
  write_connection({}, path);
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(path).permissions(), perms::owner_read | perms::owner_write);
}

TEST(ConnectionFile, ThatIsMissingOrBrokenIsNamed) {
  const testing::ScratchFolder folder;
  EXPECT_THAT([&] { read_connection(folder.path() / "none"); },
              ThrowsMessage<Error>(HasSubstr("none: cannot read the connection file")));
  std::ofstream(folder.path() / "cut") << R"({"role": "fluid", "endpoint")";
  EXPECT_THAT([&] { read_connection(folder.path() / "cut"); },
              ThrowsMessage<Error>(HasSubstr("cut: not a connection file")));
  std::ofstream(folder.path() / "gas") << R"({"role": "gas"})";
  EXPECT_THAT([&] { read_connection(folder.path() / "gas"); },
              ThrowsMessage<Error>(HasSubstr("role is \"gas\", must be fluid or solid")));
}

TEST(Token, HasThirtyTwoDigitsAndIsNewEachTime) {
  EXPECT_EQ(new_token().size(), 32U);
  EXPECT_NE(new_token(), new_token());
}

}  // namespace
}  // namespace cosurge
