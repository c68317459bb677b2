#include "coupler/lattice_mesh.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "common/case/bodies.hpp"
#include "common/case/from_case.hpp"
#include "common/case/several_solids.hpp"
#include "common/geometry/body_sites.hpp"

namespace cosurge {
namespace {

template <int dim>
using Site = std::array<long, dim>;

/// Corners of a cell from its lowest one, in the order of VTK: around the floor, then around the top.
template <int dim>
std::vector<Site<dim>> corners() {
  if constexpr (dim == 2)
    return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  else
    return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
}

template <int dim>
class LatticeMesh {
 public:
  LatticeMesh(const v1::Case& the_case, const Array& position) : spacing_(solid_spacing(the_case)) {
    for (const v1::Body& body : the_case.solid().body())
      bodies_.emplace_back(from_case<dim>(shape_of(body)), spacing_);
    for (std::size_t p = 0; p < position.values.size() / dim; ++p) add(position.values.data() + dim * p, p);
  }

  std::vector<int> connection() const {
    std::vector<int> out;
    for (const auto& [site, particle] : particle_) {
      std::vector<int> cell;
      for (const Site<dim>& corner : corners<dim>()) {
        Site<dim> there = site;
        for (std::size_t k = 0; k < dim; ++k) there[k] += corner[k];
        const auto found = particle_.find(there);
        if (found == particle_.end() || found->second.body != particle.body) break;
        cell.push_back(found->second.number);
      }
      if (cell.size() == corners<dim>().size()) out.insert(out.end(), cell.begin(), cell.end());
    }
    return out;
  }

 private:
  struct Particle {
    int number;
    int body;
  };

  /// Returns the site of a particle; nothing if the particle stands on no site of a body.
  void add(const float* values, std::size_t number) {
    constexpr double near = 0.01;  // [spacings] tolerance for positions rounded to float
    Site<dim> site;
    Vec<dim> x;
    for (int k = 0; k < dim; ++k) {
      const double s = values[k] / spacing_ - 0.5;
      site[static_cast<std::size_t>(k)] = std::lround(s);
      if (!(std::abs(s - std::round(s)) < near)) return;
      x[k] = (std::round(s) + 0.5) * spacing_;
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      if (bodies_[b].contains(x)) {
        particle_[site] = {static_cast<int>(number), static_cast<int>(b)};
        return;
      }
  }

  double spacing_;
  std::vector<BodySites<dim>> bodies_;
  std::map<Site<dim>, Particle> particle_;
};

}  // namespace

Mesh points_mesh(std::size_t particles) {
  Mesh mesh;
  mesh.connection.resize(particles);
  std::iota(mesh.connection.begin(), mesh.connection.end(), 0);
  return mesh;
}

Mesh lattice_mesh(const v1::Case& the_case, const Array& position) {
  const bool one_lattice = !has_several_solids(the_case);
  const bool has_lattice = one_lattice && (the_case.solid().has_spacing() || the_case.has_fluid());
  Mesh mesh;
  if (has_lattice && position.components == the_case.dimension()) {
    mesh.corners = 1 << the_case.dimension();
    mesh.connection = the_case.dimension() == 2 ? LatticeMesh<2>(the_case, position).connection()
                                                : LatticeMesh<3>(the_case, position).connection();
  }
  if (mesh.connection.empty())
    mesh = points_mesh(position.values.size() / static_cast<std::size_t>(position.components));
  return mesh;
}

}  // namespace cosurge
