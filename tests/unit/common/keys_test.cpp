#include "common/wire/keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "common/wire/channel.hpp"
#include "proto/exchange.pb.h"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/second_address.hpp"

namespace cosurge {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Makes this process the one of another machine, as far as keys are concerned.
class Keys : public ::testing::Test {
 protected:
  void SetUp() override { be("here"); }
  void TearDown() override { unsetenv("XDG_CONFIG_HOME"); }

  void be(const std::string& machine) const {
    setenv("XDG_CONFIG_HOME", (folder_.path() / machine).c_str(), 1);
  }

  fs::path list(const std::string& text) const {
    const fs::path file = folder_.path() / "allowed";
    std::ofstream(file) << text;
    return file;
  }

  const testing::ScratchFolder folder_;
};

TEST_F(Keys, AreMadeOnceAndForTheirOwnerOnly) {
  EXPECT_FALSE(machine_keys());
  const CurveKeys made = make_machine_keys();
  EXPECT_EQ(made.open.size(), 40U);
  EXPECT_NE(made.open, made.secret);
  const auto read = machine_keys();
  ASSERT_TRUE(read);
  EXPECT_EQ(read->open, made.open);
  EXPECT_EQ(read->secret, made.secret);
  EXPECT_EQ(fs::status(secret_key_file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_THAT([] { make_machine_keys(); },
              ThrowsMessage<Error>(HasSubstr("secret_key: cannot be written: File exists")));
}

TEST_F(Keys, ThatOthersMayReadAreRefused) {
  make_machine_keys();
  fs::permissions(secret_key_file(), fs::perms::group_read, fs::perm_options::add);
  EXPECT_THAT(
      [] { machine_keys(); },
      ThrowsMessage<Error>(AllOf(HasSubstr("others may read the secret key of this machine; chmod 600 "),
                                 HasSubstr("secret_key"))));
}

TEST_F(Keys, ThatAreDamagedAreRefused) {
  make_machine_keys();
  for (const std::string text : {"", "short", "0123456789012345678901234567890123456789x", "~~~~"}) {
    std::ofstream(secret_key_file()) << text;
    EXPECT_THAT([] { machine_keys(); },
                ThrowsMessage<Error>(HasSubstr("is not a secret key of 40 characters")));
  }
}

TEST_F(Keys, OfOtherMachinesAreReadFromAListWithAllErrorsAtOnce) {
  const std::string a = new_curve_keys().open, b = new_curve_keys().open;
  const auto machines = read_allowed_machines(list("# comment\n\nnode1 " + a + "\n  node2\t" + b + "\r\n"));
  ASSERT_EQ(machines.size(), 2U);
  EXPECT_EQ(machines[0].name, "node1");
  EXPECT_EQ(machines[1].key, b);
  EXPECT_THAT(
      [&] { read_allowed_machines(list("node1 " + a + "\nnode2\nnode3 " + b + " more\nnode4 short\n")); },
      ThrowsMessage<Error>(AllOf(HasSubstr("allowed:2: must have a name and a public key"),
                                 HasSubstr("allowed:3: "), HasSubstr("allowed:4: "),
                                 ::testing::Not(HasSubstr("allowed:1")))));
  EXPECT_THAT([&] { read_allowed_machines(list("# nobody\n")); },
              ThrowsMessage<Error>(HasSubstr("allowed: has no machine in it: nobody could connect")));
  EXPECT_THAT([&] { read_allowed_machines(folder_.path() / "none"); },
              ThrowsMessage<Error>(HasSubstr("none: no such file")));
}

TEST_F(Keys, OnAListThatAnybodyMayWriteToAreRefused) {
  const fs::path file = list("node " + new_curve_keys().open + "\n");
  fs::permissions(file, fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT([&] { read_allowed_machines(file); },
              ThrowsMessage<Error>(HasSubstr("anybody on this machine may add a key to it; chmod o-w ")));
}

v1::Request words(const std::string& reason) {
  v1::Request request;
  request.mutable_abort()->set_reason(reason);
  return request;
}

TEST_F(Keys, AreNeededWhereOtherMachinesCanConnect) {
  for (const std::string endpoint : {"tcp://*:*", "tcp://0.0.0.0:*", "tcp://[::]:*"})
    EXPECT_THAT([&] { Channel::listen(endpoint, {}); },
                ThrowsMessage<Error>(AllOf(HasSubstr("cannot listen at " + endpoint + " without keys"),
                                           HasSubstr("--allow FILE"))));
  EXPECT_NO_THROW(Channel::listen("tcp://127.0.0.1:*", {}));
  const Connection elsewhere{.endpoint = "tcp://192.0.2.77:5555", .server_key = new_curve_keys().open};
  EXPECT_THAT([&] { Channel::connect(elsewhere, {}); },
              ThrowsMessage<Error>(HasSubstr("this machine has no keys; run cosurge keys")));
  make_machine_keys();
  EXPECT_NO_THROW(Channel::connect(elsewhere, {}));
}

/// Of the addresses at which this machine can be reached.
class Addresses : public Keys, public ::testing::WithParamInterface<bool> {
 protected:
  /// Connects, and sends a word.
  static Channel knock(const Channel& coupler) {
    Channel solver = Channel::connect({.endpoint = coupler.endpoint(), .server_key = coupler.server_key()},
                                      {.peer = "the coupler", .patience = 20});
    solver.send(words("I am one"));
    return solver;
  }
};

TEST_P(Addresses, LetInTheMachinesOnTheListOnly) {
  const std::string address = GetParam() ? testing::second_address() : "127.0.0.1";
  if (address.empty()) GTEST_SKIP() << "this machine has one address only";
  be("allowed");
  const std::vector<AllowedMachine> allowed = {{"other", new_curve_keys().open},
                                               {"allowed", make_machine_keys().open}};
  Channel coupler =
      Channel::listen("tcp://" + address + ":*", {.peer = "the solver", .patience = 20, .allowed = allowed});
  v1::Request received;
  std::thread waits([&] { coupler.receive(received, "a message"); });
  be("foreign");
  make_machine_keys();
  Channel stranger = knock(coupler);
  EXPECT_THAT(
      [&] {
        v1::Request none;
        stranger.receive(none, "a welcome");
      },
      ThrowsMessage<PeerLost>(HasSubstr("the coupler does not allow the key of this machine")));
  be("allowed");
  Channel solver = knock(coupler);
  waits.join();
  EXPECT_EQ(received.abort().reason(), "I am one");
  coupler.send(words("welcome"));
  solver.receive(received, "a welcome");
  EXPECT_EQ(received.abort().reason(), "welcome");
}

TEST_P(Addresses, SayWhomTheyRefusedWhenNobodyElseCame) {
  const std::string address = GetParam() ? testing::second_address() : "127.0.0.1";
  if (address.empty()) GTEST_SKIP() << "this machine has one address only";
  Channel coupler =
      Channel::listen("tcp://" + address + ":*",
                      {.peer = "the solver", .patience = 2, .allowed = {{"other", new_curve_keys().open}}});
  const std::string key = make_machine_keys().open;
  const Channel stranger = knock(coupler);
  v1::Request received;
  EXPECT_THAT([&] { coupler.receive(received, "its hello"); },
              ThrowsMessage<PeerLost>(AllOf(HasSubstr("the solver: no message within 2 s"),
                                            HasSubstr(address + " was refused: its public key " + key +
                                                      " is not among those allowed"))));
}

INSTANTIATE_TEST_SUITE_P(Keys, Addresses, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "second_address" : "loopback"; });

}  // namespace
}  // namespace cosurge
