#include "common/wire/side.hpp"

#include "common/error.hpp"
#include "common/wire/convert.hpp"
#include "common/wire/timed_call.hpp"

namespace cosurge {
namespace {

class FluidSide : public Side {
 public:
  explicit FluidSide(Fluid& fluid) : fluid_(fluid) {}

  void initialize(const v1::Initialize& request, v1::Reply& reply) override {
    const v1::Case& scene = request.the_case();
    Interface interface;
    const Setup setup = timed(reply, [&] { return fluid_.initialize(scene, interface, load_); });
    motion_ = InterfaceMotion::at_rest(scene.dimension(), interface.points());
    v1::Initialized& initialized = *reply.mutable_initialized();
    encode(setup, initialized);
    encode(interface, *initialized.mutable_interface());
    encode(load_, *initialized.mutable_load());
  }

  void advance(const v1::Advance& request, v1::Reply& reply) override {
    require(request.has_motion(), "no motion for the fluid");
    decode(request.motion(), motion_);
    const Window window = decode(request.window());
    encode(timed(reply, [&] { return fluid_.advance(window, motion_, load_); }), *reply.mutable_advanced());
    encode(load_, *reply.mutable_advanced()->mutable_load());
  }

 private:
  Fluid& fluid_;
  InterfaceMotion motion_;
  InterfaceLoad load_;
};

class SolidSide : public Side {
 public:
  explicit SolidSide(Solid& solid) : solid_(solid) {}

  void initialize(const v1::Initialize& request, v1::Reply& reply) override {
    const v1::Case& scene = request.the_case();
    const int dimension = scene.dimension();
    Interface interface {
      .dimension = dimension, .position = Field(dimension, 0), .area = Field(dimension, 0), .body = {}
    };
    if (request.has_interface())
      interface = decode(request.interface(), dimension, scene.solid().body_size());
    load_ = InterfaceLoad::zero(dimension, interface.points());
    if (request.has_load()) decode(request.load(), load_);
    const Setup setup = timed(reply, [&] { return solid_.initialize(scene, interface, load_, motion_); });
    encode(setup, *reply.mutable_initialized());
    encode(motion_, *reply.mutable_initialized()->mutable_motion());
  }

  void advance(const v1::Advance& request, v1::Reply& reply) override {
    require(request.has_load(), "no load for the solid");
    decode(request.load(), load_);
    const Window window = decode(request.window());
    encode(timed(reply, [&] { return solid_.advance(window, load_, motion_); }), *reply.mutable_advanced());
    encode(motion_, *reply.mutable_advanced()->mutable_motion());
  }

 private:
  Solid& solid_;
  InterfaceLoad load_;
  InterfaceMotion motion_;
};

}  // namespace

std::unique_ptr<Side> side_of(Participant& participant) {
  if (participant.role() == Role::fluid)
    return std::make_unique<FluidSide>(dynamic_cast<Fluid&>(participant));
  return std::make_unique<SolidSide>(dynamic_cast<Solid&>(participant));
}

}  // namespace cosurge
