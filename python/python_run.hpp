// Runs of a case for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace cosurge {

/// A case: the path of a folder or file, or, where that is empty, a text, whose files lie in `folder`.
struct CaseSource {
  std::string path;
  std::string text;
  std::string folder = ".";
  std::vector<std::string> set;  ///< "key.path=value"
};

struct PythonRun {
  CaseSource source;
  std::string out;             ///< folder of the results; empty: as cosurge run
  pybind11::object solid;      ///< None, a command, or a cosurge.Solid
  pybind11::object on_window;  ///< None, or called with the time and a dict of values; True ends the run
  bool wire = false;           ///< solvers as programs of their own, behind the wire
  int threads = 0;             ///< of the fluid solver; 0: one per core
};

/// The case with all its defaults, as JSON. @throws Error with all that is wrong.
std::string checked_case(const CaseSource& source);

/// Runs a case and returns the folder of its results. What a callback or a solid in Python throws is thrown
/// again; an interruption from the keyboard ends the run in order, then is thrown.
/// @throws Error or NumericalError where the run fails; its results up to then are kept.
std::string run_from_python(const PythonRun& run);

}  // namespace cosurge
