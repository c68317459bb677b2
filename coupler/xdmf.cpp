#include "coupler/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace cosurge {
namespace {

/// A name of somebody's choice, as it may stand in XML.
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
    fmt::format_to(
        out_,
        "   <Grid Name=\"{}\" GridType=\"Uniform\">\n"
        "    <Time Value=\"{:.17g}\"/>\n"
        "    <Topology TopologyType=\"Polyvertex\" NodesPerElement=\"1\" NumberOfElements=\"{}\"/>\n"
        "    <Geometry GeometryType=\"{}\">\n",
        cloud.name, time, position.particles, position.components == 2 ? "XY" : "XYZ");
    slab(position);
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
    if (array.components == 2) {
      fmt::format_to(out_,
                     "     <DataItem ItemType=\"Function\" Function=\"JOIN($0, $1, 0*$0)\" "
                     "Dimensions=\"{} 3\">\n",
                     array.particles);
      component(array, 0);
      component(array, 1);
      fmt::format_to(out_, "     </DataItem>\n");
    } else {
      slab(array);
    }
    fmt::format_to(out_, "    </Attribute>\n");
  }

  /// All components of this frame.
  void slab(const XdmfArray& array) {
    if (array.components == 1)
      select(fmt::format("{}", array.particles), fmt::format("{} 0 1 1 1 {}", frame_, array.particles), 2,
             array);
    else
      select(fmt::format("{} {}", array.particles, array.components),
             fmt::format("{} 0 0 1 1 1 1 {} {}", frame_, array.particles, array.components), 3, array);
  }

  void component(const XdmfArray& array, int k) {
    select(fmt::format("{}", array.particles),
           fmt::format("{} 0 {} 1 1 1 1 {} 1", frame_, k, array.particles), 3, array);
  }

  /// `selection`: start, stride and count in each of the `rank` dimensions of the array.
  void select(const std::string& size, const std::string& selection, int rank, const XdmfArray& array) {
    const std::string last = array.components == 1 ? "" : fmt::format(" {}", array.components);
    fmt::format_to(out_,
                   "     <DataItem ItemType=\"HyperSlab\" Type=\"HyperSlab\" Dimensions=\"{}\">\n"
                   "      <DataItem Dimensions=\"3 {}\" NumberType=\"Int\" Format=\"XML\">{}</DataItem>\n"
                   "      <DataItem Dimensions=\"{} {}{}\" NumberType=\"Float\" Precision=\"4\" "
                   "Format=\"HDF\">{}:{}</DataItem>\n"
                   "     </DataItem>\n",
                   size, rank, selection, frames_, array.particles, last, file_, escaped(array.place));
  }

  std::back_insert_iterator<std::string> out_;
  const std::string& file_;
  std::size_t frame_;
  std::size_t frames_;
};

}  // namespace

std::string xdmf(const std::string& file, const std::vector<double>& times,
                 const std::vector<XdmfCloud>& clouds) {
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n <Domain>\n";
  for (const XdmfCloud& cloud : clouds) {
    const auto position = std::find_if(cloud.arrays.begin(), cloud.arrays.end(),
                                       [](const XdmfArray& array) { return array.name == "position"; });
    if (position == cloud.arrays.end() || position->particles == 0) continue;
    text +=
        fmt::format("  <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", cloud.name);
    for (std::size_t frame = 0; frame < times.size(); ++frame)
      Grid(text, file, frame, times.size()).write(cloud, *position, times[frame]);
    text += "  </Grid>\n";
  }
  return text + " </Domain>\n</Xdmf>\n";
}

}  // namespace cosurge
