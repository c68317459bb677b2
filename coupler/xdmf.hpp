// The frames of a run as ParaView and VisIt read them: an XML file that says what lies where in the HDF5
// file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cosurge {

/// An array of all frames.
struct XdmfArray {
  std::string name;   ///< "pressure"; "position" says where the particles are
  std::string place;  ///< in the HDF5 file: "/frames/fluid/pressure"
  std::uint64_t particles;
  int components;
};

/// The particles of one solver.
struct XdmfCloud {
  std::string name;  ///< "fluid"
  std::vector<XdmfArray> arrays;
};

/// An XDMF 2 document: a temporal collection of polyvertex grids for every cloud that has positions and
/// particles. Vectors of two components get a zero for the third. To be opened with ParaView's "XDMF Reader":
/// its Xdmf3 readers do not know the HyperSlab items that pick a frame out of an array.
/// `file`: name of the HDF5 file beside it; `times`: of the frames [s].
std::string xdmf(const std::string& file, const std::vector<double>& times,
                 const std::vector<XdmfCloud>& clouds);

}  // namespace cosurge
