#include "storage/ingest/grids/resampling.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/ingest_format_messages.hpp"
#include "engine/ocean/grids/bilinear.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/grids/cell_weights.hpp"
#include "storage/ingest/grids/tangent_plane.hpp"

namespace floeplan::ingest {
namespace {

constexpr double least_weight = 1e-6;  // below it a point does not count, also when it is missing
constexpr float least_share_of_water = 0.5F;
constexpr std::size_t fair_candidates =
    10'000'000;  // nodes looked at whatever the size: a fraction of a second
constexpr std::size_t candidates_per_node =
    30;  // real meshes need 2 to 6, slender cells athwart the grid more

}  // namespace

Checked<std::shared_ptr<const Resampling>> Resampling::of(const SourceMesh& mesh,
                                                          const ocean::HorizontalGrid& grid) {
  std::shared_ptr<Resampling> result{new Resampling{grid.size()}};
  const std::size_t affordable = fair_candidates + candidates_per_node * (grid.size() + mesh.cells.size());
  std::size_t candidates = 0;
  for (const SourceMesh::Cell& cell : mesh.cells) {
    const NodeBox box = nodes_near(grid, mesh, cell);
    if (box.count_x == 0 || box.count_y == 0) continue;
    candidates += box.count_x * box.count_y;
    if (candidates > affordable) return refuse(messages::ingest_format_message<"cells-overlap">());
    result->add(mesh, cell, grid, box);
  }
  return result;
}

void Resampling::add(const SourceMesh& mesh, const SourceMesh::Cell& cell, const ocean::HorizontalGrid& grid,
                     const NodeBox& box) {
  const auto is_free = [](const Stencil& stencil) {
    return stencil.along == std::array<float, 4>{} && stencil.across == std::array<float, 4>{};
  };
  const std::size_t columns = grid.x().size();
  const CellWeights weights{mesh, cell};
  for (std::size_t iy = box.first_y; iy < box.first_y + box.count_y; ++iy) {
    for (std::size_t i = 0; i < box.count_x; ++i) {
      const std::size_t ix = (box.first_x + i) % columns;
      Stencil& stencil = stencils_[iy * columns + ix];
      if (!is_free(stencil)) continue;
      const geo::LonLat node = grid.place(ix, iy);
      const auto inside = weights.at(unit_vector(node));
      if (!inside) continue;
      for (std::size_t corner = 0; corner < cell.size(); ++corner) {
        const double weight = (*inside)[corner];
        if (weight < least_weight) continue;
        const double turn = convergence(mesh.points[cell[corner]], node);
        stencil.point[corner] = cell[corner];
        stencil.along[corner] = static_cast<float>(weight * std::cos(turn));
        stencil.across[corner] = static_cast<float>(weight * std::sin(turn));
      }
    }
  }
}

std::vector<float> Resampling::apply(std::span<const float> values) const {
  std::vector<float> out(stencils_.size(), missing);
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

VelocitySlice Resampling::apply(std::span<const float> east, std::span<const float> north) const {
  VelocitySlice out{std::vector<float>(stencils_.size(), missing),
                    std::vector<float>(stencils_.size(), missing), 0};
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const Stencil& stencil = stencils_[node];
    float share = 0.0F;
    float u = 0.0F;
    float v = 0.0F;
    for (std::size_t i = 0; i < stencil.point.size(); ++i) {
      const float along = stencil.along[i];
      const float across = stencil.across[i];
      if (along == 0.0F && across == 0.0F) continue;
      const float from_east = east[stencil.point[i]];
      const float from_north = north[stencil.point[i]];
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

void ResamplingError::add(const SourceMesh& mesh, const VelocitySlice& source,
                          const ocean::HorizontalGrid& grid, const VelocitySlice& stored) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (std::isnan(source.east[i]) || std::isnan(source.north[i])) continue;
    if (!std::isfinite(mesh.points[i].lon_deg) || !std::isfinite(mesh.points[i].lat_deg)) continue;
    const auto at = grid.locate(mesh.points[i]);
    if (!at) continue;
    const auto east = ocean::bilinear(stored.east, grid.x().size(), *at);
    const auto north = ocean::bilinear(stored.north, grid.x().size(), *at);
    if (!east || !north) continue;
    const double u = static_cast<double>(source.east[i]);
    const double v = static_cast<double>(source.north[i]);
    const double apart = std::hypot(*east - u, *north - v);
    squares_ += apart * apart;
    speeds_ += u * u + v * v;
    largest_m_s_ = std::max(largest_m_s_, apart);
    ++points_;
  }
}

double ResamplingError::rms_m_s() const {
  return points_ == 0 ? 0.0 : std::sqrt(squares_ / static_cast<double>(points_));
}

double ResamplingError::rms_speed_m_s() const {
  return points_ == 0 ? 0.0 : std::sqrt(speeds_ / static_cast<double>(points_));
}

}  // namespace floeplan::ingest
