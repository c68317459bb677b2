#include "fluid_solver/fitted_layout.hpp"

#include <algorithm>
#include <cmath>

#include "fluid_solver/even_layer.hpp"
#include "fluid_solver/face_grid.hpp"

namespace cosurge::fluid {
namespace {

constexpr double beside = 1.0;   // spacings farther than the nearest facet, within which no facet is oblique
constexpr double behind = 0.25;  // [spacings] from the last layer to the lattice, beyond half a spacing
constexpr double gap = 0.95;     // [spacings] a lattice site farther than this from all particles fills a gap

constexpr int wall_sweeps = 40, dummy_sweeps = 10;

/// Points of a unit cell that fill it evenly without rows: multiples of irrational numbers, the inverse
/// powers of the root of r^(dim+1) = r + 1.
template <int dim>
std::vector<Vec<dim>> scattered(int count) {
  constexpr double root = dim == 2 ? 1.324717957244746 : 1.2207440846057596;
  std::vector<Vec<dim>> points(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    for (int axis = 0; axis < dim; ++axis) {
      const double multiple = 0.5 + (k + 1) * std::pow(root, -(axis + 1));
      points[static_cast<std::size_t>(k)][axis] = multiple - std::floor(multiple) - 0.5;
    }
  return points;
}

/// Whether a site of the lattice has one beside it that is not of the shape.
template <int dim>
bool is_bare(const Shape<dim>& shape, const Vec<dim>& x, double spacing) {
  for (int axis = 0; axis < dim; ++axis)
    for (const double side : {-spacing, spacing}) {
      Vec<dim> across = x;
      across[axis] += side;
      if (!shape.contains(across)) return true;
    }
  return false;
}

/// Whether parts of the outline overlap: facets of one part that lie within another are no faces.
template <int dim>
bool has_overlaps(const Shape<dim>& shape, const std::vector<Vec<dim>>& sites) {
  return !shape.is_box() && std::any_of(sites.begin(), sites.end(),
                                        [&](const auto& x) { return std::abs(shape.winding(x)) > 1; });
}

template <int dim>
class Layout {
 public:
  Layout(const Shape<dim>& shape, const std::optional<Box<dim>>& tank, int dummy_layers, double spacing)
      : shape_(shape),
        layers_(1 + dummy_layers),
        spacing_(spacing),
        outline_(shape, tank, spacing),
        faces_(FaceGrid<dim>::faces(outline_.oblique(), spacing)),
        kept_(EvenLayer<dim>::reach * spacing) {}

  std::vector<WallSite<dim>> sites() {
    keep_lattice();
    if (rest_.empty()) return sites_;
    measure_cells();
    std::vector<EvenLayer<dim>> layers;
    for (int k = 0; k < layers_; ++k) layers.push_back(layer((k + 0.5) * spacing_));
    for (std::size_t k = 0; k < layers.size(); ++k)
      for (const Vec<dim>& x : layers[k].points())
        sites_.push_back({.x = x, .kind = k == 0 ? Kind::wall : Kind::dummy});
    fill_gaps();
    return sites_;
  }

 private:
  /// Sites deeper than the layers, and beside aligned faces, stay.
  void keep_lattice() {
    const double deepest = (layers_ + behind) * spacing_;
    const std::vector<Vec<dim>> lattice = shape_.fill(spacing_);
    const bool as_it_is = has_overlaps(shape_, lattice);
    for (const Vec<dim>& x : lattice) {
      const double depth = outline_.at(x).depth;
      if (!as_it_is && !outline_.on_lattice(x, beside * spacing_) && depth < deepest) {
        rest_.push_back(x);
        continue;
      }
      kept_.add(x);
      sites_.push_back({.x = x, .kind = is_bare(shape_, x, spacing_) ? Kind::wall : Kind::dummy});
    }
  }

  /// Cells of the lattice that may hold points of a layer, with the depth of their centres.
  void measure_cells() {
    const Vec<dim> margin = Vec<dim>::Constant(spacing_);
    const double deepest = (layers_ + 1) * spacing_;
    const auto cells = fill(Box<dim>(shape_.bounds().min - margin, shape_.bounds().max + margin), spacing_);
    std::vector<Depth<dim>> depth(cells.size());
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < cells.size(); ++k) depth[k] = outline_.at(cells[k]);
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (std::abs(depth[k].depth) < deepest) cells_.push_back({cells[k], depth[k].depth, depth[k].nearest});
  }

  EvenLayer<dim> layer(double depth) const {
    EvenLayer<dim> layer(outline_, kept_, depth, spacing_);
    std::vector<Vec<dim>> grid;
    for (const FaceGrid<dim>& face : faces_)
      for (const Vec<dim>& x : face.points(outline_, depth, spacing_)) grid.push_back(x);
    layer.add_grid(grid);
    layer.fill(candidates(layer, depth));
    layer.spread(depth < spacing_ ? wall_sweeps : dummy_sweeps);
    return layer;
  }

  /// Candidates that lie a little deeper than the layer are moved up to it, where there is room.
  std::vector<Vec<dim>> candidates(const EvenLayer<dim>& layer, double depth) const {
    constexpr int per_cell = dim == 2 ? 256 : 32;
    const double thickness = spacing_ / (dim == 2 ? 16 : 2);
    static const std::vector<Vec<dim>> offsets = scattered<dim>(per_cell);
    const double half_diagonal = 0.5 * std::sqrt(dim) * spacing_;
    std::vector<std::vector<Vec<dim>>> found(cells_.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto& [centre, centre_depth, nearest] = cells_[c];
      if (std::abs(centre_depth - depth) > half_diagonal + thickness) continue;
      for (const Vec<dim>& offset : offsets) {
        const Vec<dim> x = centre + spacing_ * offset;
        if (centre_depth > 0 && (x - nearest).squaredNorm() < depth * depth) continue;  // not so deep
        if (centre_depth - spacing_ * offset.norm() > depth + thickness) continue;      // deeper
        if (layer.occupied(x, thickness)) continue;
        const Depth<dim> here = outline_.at(x);
        if (here.depth < depth || here.depth >= depth + thickness) continue;
        const Vec<dim> on = here.nearest + depth / here.depth * (x - here.nearest);
        if (!layer.occupied(on, 0)) found[c].push_back(on);
      }
    }
    std::vector<Vec<dim>> candidates;
    for (const auto& of_cell : found) candidates.insert(candidates.end(), of_cell.begin(), of_cell.end());
    return candidates;
  }

  void fill_gaps() {
    PointHash<dim> all(EvenLayer<dim>::reach * spacing_);
    for (const auto& site : sites_) all.add(site.x);
    for (const Vec<dim>& x : rest_) {
      if (all.any_within(x, gap * spacing_)) continue;
      all.add(x);
      sites_.push_back({.x = x, .kind = outline_.at(x).depth < spacing_ ? Kind::wall : Kind::dummy});
    }
  }

  struct Cell {
    Vec<dim> centre;
    double depth;
    Vec<dim> nearest;  // point of the outline
  };

  const Shape<dim>& shape_;
  int layers_;
  double spacing_;
  OutlineDepth<dim> outline_;
  std::vector<FaceGrid<dim>> faces_;
  PointHash<dim> kept_;         // sites of the lattice
  std::vector<Vec<dim>> rest_;  // sites of the lattice that give way to layers
  std::vector<Cell> cells_;
  std::vector<WallSite<dim>> sites_;
};

}  // namespace

template <int dim>
std::vector<WallSite<dim>> fitted_layout(const Shape<dim>& shape, const std::optional<Box<dim>>& tank,
                                         int dummy_layers, double spacing) {
  return Layout<dim>(shape, tank, dummy_layers, spacing).sites();
}

template std::vector<WallSite<2>> fitted_layout(const Shape<2>&, const std::optional<Box<2>>&, int, double);
template std::vector<WallSite<3>> fitted_layout(const Shape<3>&, const std::optional<Box<3>>&, int, double);

}  // namespace cosurge::fluid
