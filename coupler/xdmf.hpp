// The frames of a run for ParaView: an XML file that refers to the arrays of the HDF5 file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cosurge {

/// An array that all frames have.
struct XdmfArray {
  std::string name;   ///< "pressure"; "position" says where the particles are
  std::string place;  ///< path in the HDF5 file: "/frames/fluid/pressure"
  std::uint64_t particles;
  int components;
};

/// The particles of one solver, with the cells between them.
struct XdmfCloud {
  std::string name;  ///< "fluid"
  std::vector<XdmfArray> arrays;
  std::string mesh = "";    ///< path of the corners of the cells in the HDF5 file: "/mesh/fluid"
  std::uint64_t cells = 0;  ///< number of cells
  int corners = 1;          ///< corners per cell: 1, 4 (quadrilaterals) or 8 (hexahedra)
};

/// An XDMF 3 document: a temporal collection of grids for every cloud that has positions and cells. Frames
/// are picked out of their arrays as ParaView's default readers (Xdmf3ReaderS, Xdmf3ReaderT) understand it,
/// "FILE:PLACE|start:stride:count:extent"; items of the type HyperSlab crash these.
/// `file`: name of the HDF5 file beside it; `times`: times of the frames [s].
std::string xdmf(const std::string& file, const std::vector<double>& times,
                 const std::vector<XdmfCloud>& clouds);

}  // namespace cosurge
