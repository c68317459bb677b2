// The coupler's side of the protocol: a solver on the far side of a wire, used like any other participant.
#pragma once

#include <string>
#include <vector>

#include "common/participant.hpp"
#include "common/wire/channel.hpp"
#include "proto/exchange.pb.h"

namespace cosurge {

/// Every call sends one request and sleeps until its reply is there. Replies are checked: sequence, kind,
/// lengths, every number finite. The first error ends the participation; it names the solver, the call and
/// the window, and the solver is told.
class RemoteParticipant : public virtual Participant {
 public:
  /// Requirements of the coupler on the solver.
  struct Expectation {
    Role role = Role::fluid;
    std::string token;
    int dimension = 2;
    std::vector<std::string> capabilities;  ///< must all be there
  };

  /// Cost of the participation so far. Time that is neither `computing` nor the coupler's own work is the
  /// exchange.
  struct Cost {
    std::uint64_t calls = 0;
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;  ///< both ways
    double total = 0;         ///< [s] in calls, all in all
    double waiting = 0;       ///< [s] of it asleep
    double computing = 0;     ///< [s] of it, the solver's computing time

    double exchange() const { return total - computing; }  ///< [s] to encode, transport and decode
  };

  /// Waits for the solver's Hello and welcomes it. `peer_ended`: see Channel.
  /// @throws Error where the solver is not what is expected (it is told why); PeerLost where it does not
  /// come.
  RemoteParticipant(Channel channel, const Expectation& expected, Channel::PeerEnded peer_ended = {});

  /// Ends the run of a solver that is not finalized.
  ~RemoteParticipant() override;

  Identity identity() const override { return identity_; }
  std::string save() override;
  void restore(const std::string& state) override;
  Snapshot frame() override;
  void finalize() override;

  /// Tells the solver that the run is over, and why; no call may follow. Without effect once the solver is
  /// finalized, has failed or was told before.
  void abort(const std::string& reason) noexcept;

  Cost cost() const;

  /// Of the next answer, see Channel.
  void set_mishap(const Channel::Mishap& mishap) { channel_.set_mishap(mishap); }

 protected:
  /// `give` fills the request beyond the case, `take` reads the reply beyond the setup.
  template <typename Give, typename Take>
  Setup initialize_by(const v1::Case& the_case, const Give& give, const Take& take);
  /// The same for the request beyond the window, and the reply beyond the report.
  template <typename Give, typename Take>
  Report advance_by(const Window& window, const Give& give, const Take& take);

 private:
  void greet(const Expectation& expected);
  void refuse(const std::string& reason);
  template <typename Call>
  auto call(std::string place, Call&& content);
  const v1::Reply& exchange(v1::Reply::ResultCase expected);

  Channel channel_;
  Identity identity_;
  v1::Request request_;
  v1::Reply reply_;
  std::string place_;  // position of the current call in the run, for errors
  bool over_ = false;
  std::uint64_t sequence_ = 0;
  std::uint32_t attempt_ = 0;  // number of the last window's attempt
  std::size_t columns_ = 0;
  std::uint64_t particles_ = 0;
  Cost cost_;
};

class RemoteFluid : public Fluid, public RemoteParticipant {
 public:
  using RemoteParticipant::RemoteParticipant;

  Setup initialize(const v1::Case& the_case, Interface& interface, InterfaceLoad& load) override;
  Report advance(const Window& window, const InterfaceMotion& motion, InterfaceLoad& load) override;
};

class RemoteSolid : public Solid, public RemoteParticipant {
 public:
  using RemoteParticipant::RemoteParticipant;

  Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                   InterfaceMotion& motion) override;
  Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) override;
};

}  // namespace cosurge
