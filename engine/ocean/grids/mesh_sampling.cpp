#include "engine/ocean/grids/mesh_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/geo/tangent_plane.hpp"
#include "engine/ocean/grids/cell_weights.hpp"
#include "engine/ocean/grids/node_box.hpp"

namespace floeplan::ocean {
namespace {

constexpr double least_weight = 1e-6;  // below it a point does not count, also when it is missing
constexpr float least_share_of_water = 0.5F;
constexpr std::size_t fair_candidates =
    10'000'000;  // nodes looked at whatever the size: a fraction of a second
constexpr std::size_t candidates_per_node =
    30;  // real meshes need 2 to 6, slender cells athwart the grid more

/// A place on the sphere, and what turns its east and north into those of another.
struct SpherePlace {
  double sin_lon{};
  double cos_lon{};
  double sin_lat{};
  double cos_lat{};

  [[nodiscard]] geo::UnitVector direction() const { return {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat}; }
};

SpherePlace on_sphere(geo::LonLat place) {
  const double lon = place.lon_deg * std::numbers::pi / 180.0;
  const double lat = place.lat_deg * std::numbers::pi / 180.0;
  return {std::sin(lon), std::cos(lon), std::sin(lat), std::cos(lat)};
}

struct Turn {
  double cosine{};
  double sine{};
};

/// By which a direction's bearing grows, clockwise, when it is carried along the great circle; as geo::convergence, of
/// places whose sines and cosines are known. The two pairs of axes differ by that turn and by the tilt from one tangent
/// plane to the other, which acts on sum and difference of their products alike.
Turn turn_between(const SpherePlace& from, const SpherePlace& to) {
  const double sine = from.cos_lon * to.sin_lon - from.sin_lon * to.cos_lon;
  const double cosine = from.cos_lon * to.cos_lon + from.sin_lon * to.sin_lon;
  const double along = cosine * (1.0 + from.sin_lat * to.sin_lat) + from.cos_lat * to.cos_lat;
  const double across = sine * (from.sin_lat + to.sin_lat);
  const double length = std::sqrt(along * along + across * across);
  return length > 0.0 ? Turn{along / length, across / length} : Turn{1.0, 0.0};
}

/// The nodes of a grid on the sphere: of a geographic one a sine and a cosine for each row and each column.
class SphereNodes {
 public:
  explicit SphereNodes(const HorizontalGrid& grid) : columns_{grid.x().size()} {
    if (std::holds_alternative<geo::GeographicFrame>(grid.frame())) {
      for (const double lon_deg : grid.x().nodes()) by_column_.push_back(on_sphere({lon_deg, 0.0}));
      for (const double lat_deg : grid.y().nodes()) by_row_.push_back(on_sphere({0.0, lat_deg}));
      return;
    }
    nodes_.reserve(grid.size());
    for (std::size_t iy = 0; iy < grid.y().size(); ++iy)
      for (std::size_t ix = 0; ix < columns_; ++ix) nodes_.push_back(on_sphere(grid.place(ix, iy)));
  }

  [[nodiscard]] SpherePlace at(std::size_t ix, std::size_t iy) const {
    if (!nodes_.empty()) return nodes_[iy * columns_ + ix];
    return {by_column_[ix].sin_lon, by_column_[ix].cos_lon, by_row_[iy].sin_lat, by_row_[iy].cos_lat};
  }

 private:
  std::size_t columns_;
  std::vector<SpherePlace> by_column_;
  std::vector<SpherePlace> by_row_;
  std::vector<SpherePlace> nodes_;  // [y][x]; empty for a geographic grid
};

}  // namespace

class MeshSampling::Builder {
 public:
  Builder(const Mesh& mesh, const HorizontalGrid& grid)
      : mesh_{mesh}, boxes_{grid, mesh}, columns_{grid.x().size()}, nodes_{grid}, stencils_(grid.size()) {
    places_.reserve(mesh.points.size());
    for (const geo::LonLat point : mesh.points) places_.push_back(on_sphere(point));
  }

  /// false: too much lies over one another.
  bool add_all() {
    const std::size_t affordable =
        fair_candidates + candidates_per_node * (stencils_.size() + mesh_.cells.size());
    std::size_t candidates = 0;
    for (const Mesh::Cell& cell : mesh_.cells) {
      const NodeBox box = boxes_.near(cell);
      if (box.count_x == 0 || box.count_y == 0) continue;
      candidates += box.count_x * box.count_y;
      if (candidates > affordable) return false;
      add(cell, box);
    }
    return true;
  }

  std::vector<Stencil> take() { return std::move(stencils_); }

 private:
  void add(const Mesh::Cell& cell, const NodeBox& box) {
    CellWeights::Corners corners{};
    for (std::size_t i = 0; i < cell.size(); ++i) corners[i] = places_[cell[i]].direction();
    const CellWeights weights{corners, cell[2] == cell[3]};
    for (std::size_t iy = box.first_y; iy < box.first_y + box.count_y; ++iy) {
      for (std::size_t i = 0; i < box.count_x; ++i) {
        const std::size_t ix = (box.first_x + i) % columns_;
        Stencil& stencil = stencils_[iy * columns_ + ix];
        if (!is_free(stencil)) continue;
        const SpherePlace node = nodes_.at(ix, iy);
        if (const auto inside = weights.at(node.direction())) stencil = stencil_of(cell, *inside, node);
      }
    }
  }

  static bool is_free(const Stencil& stencil) {
    return stencil.along == std::array<float, 4>{} && stencil.across == std::array<float, 4>{};
  }

  [[nodiscard]] Stencil stencil_of(const Mesh::Cell& cell, const std::array<double, 4>& weights,
                                   const SpherePlace& node) const {
    Stencil stencil;
    for (std::size_t corner = 0; corner < cell.size(); ++corner) {
      const double weight = weights[corner];
      if (weight < least_weight) continue;
      const Turn turn = turn_between(places_[cell[corner]], node);
      stencil.point[corner] = cell[corner];
      stencil.along[corner] = static_cast<float>(weight * turn.cosine);
      stencil.across[corner] = static_cast<float>(weight * turn.sine);
    }
    return stencil;
  }

  const Mesh& mesh_;
  NodeBoxes boxes_;
  std::size_t columns_;
  SphereNodes nodes_;
  std::vector<SpherePlace> places_;  // of the mesh's points
  std::vector<Stencil> stencils_;
};

std::optional<MeshSampling> MeshSampling::of(const Mesh& mesh, const HorizontalGrid& grid) {
  Builder builder{mesh, grid};
  if (!builder.add_all()) return std::nullopt;
  return MeshSampling{builder.take()};
}

std::vector<float> MeshSampling::apply(std::span<const float> values) const {
  std::vector<float> out(stencils_.size(), missing_sample);
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const Stencil& stencil = stencils_[node];
    float share = 0.0F;
    float sum = 0.0F;
    for (std::size_t i = 0; i < stencil.point.size(); ++i) {
      const float weight =
          std::sqrt(stencil.along[i] * stencil.along[i] + stencil.across[i] * stencil.across[i]);
      if (weight == 0.0F || std::isnan(values[stencil.point[i]])) continue;
      share += weight;
      sum += weight * values[stencil.point[i]];
    }
    if (share >= least_share_of_water) out[node] = sum / share;
  }
  return out;
}

PointVelocities MeshSampling::apply(const PointVelocities& values) const {
  PointVelocities out{std::vector<float>(stencils_.size(), missing_sample),
                      std::vector<float>(stencils_.size(), missing_sample)};
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const Stencil& stencil = stencils_[node];
    float share = 0.0F;
    float u = 0.0F;
    float v = 0.0F;
    for (std::size_t i = 0; i < stencil.point.size(); ++i) {
      const float along = stencil.along[i];
      const float across = stencil.across[i];
      if (along == 0.0F && across == 0.0F) continue;
      const float from_east = values.east[stencil.point[i]];
      const float from_north = values.north[stencil.point[i]];
      if (std::isnan(from_east) || std::isnan(from_north)) continue;
      share += std::sqrt(along * along + across * across);
      u += along * from_east + across * from_north;
      v += along * from_north - across * from_east;
    }
    if (share < least_share_of_water) continue;
    out.east[node] = u / share;
    out.north[node] = v / share;
  }
  return out;
}

}  // namespace floeplan::ocean
