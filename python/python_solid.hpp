// A structure that is an object of Python.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <memory>

#include "common/participant.hpp"

namespace cosurge {

/// What an object of Python has thrown, for the caller in Python: the run passes on its words alone.
using Thrown = std::shared_ptr<std::exception_ptr>;

/// Calls the methods of a cosurge.Solid (python/cosurge/solid.py). Its calls take the interpreter's lock;
/// they may come from any thread that does not hold it.
class PythonSolid : public Solid {
 public:
  /// Takes `solid` over; the caller holds the interpreter's lock. `thrown` gets what its methods throw.
  PythonSolid(pybind11::object solid, Thrown thrown);
  ~PythonSolid() override;

  Identity identity() const override;
  Setup initialize(const v1::Case& the_case, const Interface& interface, const InterfaceLoad& load,
                   InterfaceMotion& motion) override;
  Report advance(const Window& window, const InterfaceLoad& load, InterfaceMotion& motion) override;
  std::string save() override;
  void restore(const std::string& state) override;
  Snapshot frame() override;

 private:
  template <typename Action>
  auto call(const char* method, Action action);

  std::string name_;
  pybind11::object solid_;
  Thrown thrown_;
  std::string start_;       // state at the start of a window that may be repeated
  std::size_t values_ = 0;  // that advance() must give
  Field position_, displacement_;
};

}  // namespace cosurge
