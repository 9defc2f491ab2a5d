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

/// Interpolates what is known at the points of a mesh at the nodes of a grid: bilinear in four-sided cells, linear in
/// triangles; at a point of the mesh its own value. Vectors are carried along the great circle from point to node, so
/// that meridians that converge do not turn them.
/// Coast    between points with and without water the mean of those with water, by their weights, as long as these are
///          at least half of all; beyond, no value. Land never counts as still water
/// Outside  no value at a node outside every cell; of cells that overlap the first counts
/// Threads  const members may be called from several threads at once
class MeshSampling {
 public:
  /// Precondition  the steps of either axis of `grid` are equal, but for a last one that is shorter
  /// Outside       nullopt for a mesh whose cells lie over one another many times over, as only damaged positions do
  [[nodiscard]] static std::optional<MeshSampling> of(const Mesh& mesh, const HorizontalGrid& grid);

  /// Shape  input: as the points; output: the grid [y][x]
  [[nodiscard]] PointVelocities apply(const PointVelocities& values) const;
  /// The same of numbers without a direction.
  [[nodiscard]] std::vector<float> apply(std::span<const float> values) const;
  /// At each node the least of the known values that are interpolated there.
  [[nodiscard]] std::vector<float> least(std::span<const float> values) const;

 private:
  /// One node: its points and, for each, its weight times the cosine and the sine of the turn to the node.
  struct Stencil {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4> along{};
    std::array<float, 4> across{};
  };

  explicit MeshSampling(std::vector<Stencil> stencils) : stencils_{std::move(stencils)} {}

  std::vector<Stencil> stencils_;
};

}  // namespace floeplan::ocean
