#include "coupler/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace cosurge {
namespace {

const char* topology(int corners) {
  return corners == 4 ? "Quadrilateral" : corners == 8 ? "Hexahedron" : "Polyvertex";
}

/// A name that a user has chosen, escaped for XML.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else if (c == '>')
      text += "&gt;";
    else if (c == '"')
      text += "&quot;";
    else
      text += c;
  }
  return text;
}

/// One cloud at one instant: writes the elements of its grid.
class Grid {
 public:
  Grid(std::string& text, const std::string& file, std::size_t frame, std::size_t frames)
      : out_(std::back_inserter(text)), file_(file), frame_(frame), frames_(frames) {}

  void write(const XdmfCloud& cloud, const XdmfArray& position, double time) {
    fmt::format_to(out_,
                   "   <Grid Name=\"{}\" GridType=\"Uniform\">\n"
                   "    <Time Value=\"{:.17g}\"/>\n"
                   "    <Topology TopologyType=\"{}\" NumberOfElements=\"{}\"{}>\n"
                   "     <DataItem Dimensions=\"{} {}\" NumberType=\"Int\" Precision=\"4\" "
                   "Format=\"HDF\">{}:{}</DataItem>\n"
                   "    </Topology>\n"
                   "    <Geometry GeometryType=\"{}\">\n",
                   cloud.name, time, topology(cloud.corners), cloud.cells,
                   cloud.corners == 1 ? " NodesPerElement=\"1\"" : "", cloud.cells, cloud.corners, file_,
                   cloud.mesh, position.components == 2 ? "XY" : "XYZ");
    values(position);
    fmt::format_to(out_, "    </Geometry>\n");
    for (const XdmfArray& array : cloud.arrays)
      if (array.name != "position" && array.particles == position.particles) attribute(array);
    fmt::format_to(out_, "   </Grid>\n");
  }

 private:
  void attribute(const XdmfArray& array) {
    const bool vector = array.components == 2 || array.components == 3;
    fmt::format_to(out_, "    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">\n",
                   escaped(array.name), vector ? "Vector" : (array.components == 1 ? "Scalar" : "Matrix"));
    values(array);
    fmt::format_to(out_, "    </Attribute>\n");
  }

  /// All of this frame: start, stride and count of the selection, and the extent of the array.
  void values(const XdmfArray& array) {
    const bool many = array.components > 1;
    const std::string size =
        many ? fmt::format("{} {}", array.particles, array.components) : fmt::format("{}", array.particles);
    const char* rest = many ? " 0" : "";
    const char* one = many ? " 1" : "";
    fmt::format_to(out_,
                   "     <DataItem Dimensions=\"{0}\" NumberType=\"Float\" Precision=\"4\" "
                   "Format=\"HDF\">{1}:{2}|{3} 0{4}:1 1{5}:1 {0}:{6} {0}</DataItem>\n",
                   size, file_, escaped(array.place), frame_, rest, one, frames_);
  }

  std::back_insert_iterator<std::string> out_;
  const std::string& file_;
  std::size_t frame_;
  std::size_t frames_;
};

}  // namespace

std::string xdmf(const std::string& file, const std::vector<double>& times,
                 const std::vector<XdmfCloud>& clouds) {
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n";
  for (const XdmfCloud& cloud : clouds) {
    const auto position = std::find_if(cloud.arrays.begin(), cloud.arrays.end(),
                                       [](const XdmfArray& array) { return array.name == "position"; });
    if (position == cloud.arrays.end() || position->particles == 0 || cloud.cells == 0) continue;
    text +=
        fmt::format("  <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", cloud.name);
    for (std::size_t frame = 0; frame < times.size(); ++frame)
      Grid(text, file, frame, times.size()).write(cloud, *position, times[frame]);
    text += "  </Grid>\n";
  }
  return text + " </Domain>\n</Xdmf>\n";
}

}  // namespace cosurge
