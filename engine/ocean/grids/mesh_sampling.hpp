#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "engine/ocean/grids/point_velocities.hpp"

namespace floeplan::ocean {

/// Interpolates values at the points of a mesh to the nodes of a grid: bilinear in four-sided cells, linear
/// in triangles; at a point of the mesh its own value. Vectors are carried along the great circle from point
/// to node, so that converging meridians do not turn them.
/// Coast    between points with and without water: the weighted mean of those with water, if their weights
///          are at least half of all; otherwise no value. Land never counts as water without current
/// Outside  no value at a node outside every cell; of overlapping cells the first counts
/// Threads  const members may be called from several threads at once
class MeshSampling {
 public:
  /// Precondition  on both axes of `grid` the steps are equal; only the last may be shorter
  /// Outside       nullopt for a mesh in which many cells overlap, as only damaged positions do
  [[nodiscard]] static std::optional<MeshSampling> of(const Mesh& mesh, const HorizontalGrid& grid);

  /// Shape  input: as the points of the mesh; output: the grid [y][x]
  [[nodiscard]] PointVelocities apply(const PointVelocities& values) const;
  /// Interpolates scalars; shape as for velocities.
  [[nodiscard]] std::vector<float> apply(std::span<const float> values) const;
  /// At each node the least of the known values that are interpolated there.
  [[nodiscard]] std::vector<float> least(std::span<const float> values) const;

 private:
  /// One node of the grid: its points, and for each point the weight times cosine and sine of the rotation to
  /// the node.
  struct Stencil {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4> along{};
    std::array<float, 4> across{};
  };

  explicit MeshSampling(std::vector<Stencil> stencils) : stencils_{std::move(stencils)} {}

  std::vector<Stencil> stencils_;
};

}  // namespace floeplan::ocean
