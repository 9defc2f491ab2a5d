#include "engine/ocean/grids/mesh_sampling.hpp"

#include <cmath>
#include <utility>

#include "engine/ocean/grids/cell_search.hpp"

namespace floeplan::ocean {
namespace {

constexpr double least_weight = 1e-6;  // a point with a smaller weight does not count, even if it is missing
constexpr float least_share_of_water = 0.5F;

}  // namespace

std::optional<MeshSampling> MeshSampling::of(const Mesh& mesh, const HorizontalGrid& grid) {
  const CellSearch search{mesh, grid};
  std::vector<Stencil> stencils(search.nodes());
  const auto is_free = [&](const Mesh::Cell& /*cell*/, std::size_t node) {
    const Stencil& stencil = stencils[node];
    return stencil.along == std::array<float, 4>{} && stencil.across == std::array<float, 4>{};
  };
  const auto fill = [&](const Mesh::Cell& cell, const std::array<double, 4>& weights, std::size_t node,
                        const SpherePlace& place) {
    Stencil stencil;
    for (std::size_t corner = 0; corner < cell.size(); ++corner) {
      const double weight = weights[corner];
      if (weight < least_weight) continue;
      const Turn turn = turn_between(search.point(cell[corner]), place);
      stencil.point[corner] = cell[corner];
      stencil.along[corner] = static_cast<float>(weight * turn.cosine);
      stencil.across[corner] = static_cast<float>(weight * turn.sine);
    }
    stencils[node] = stencil;
  };
  if (!search.visit(is_free, fill)) return std::nullopt;
  return MeshSampling{std::move(stencils)};
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

std::vector<float> MeshSampling::least(std::span<const float> values) const {
  std::vector<float> out(stencils_.size(), missing_sample);
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const Stencil& stencil = stencils_[node];
    for (std::size_t i = 0; i < stencil.point.size(); ++i) {
      if (stencil.along[i] == 0.0F && stencil.across[i] == 0.0F) continue;
      const float value = values[stencil.point[i]];
      if (!(out[node] <= value) && !std::isnan(value)) out[node] = value;
    }
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
