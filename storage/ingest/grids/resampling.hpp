#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/grids/node_box.hpp"
#include "storage/ingest/grids/source_mesh.hpp"
#include "storage/ingest/grids/velocity_source.hpp"

namespace floeplan::ingest {

/// Brings currents, or plain numbers, from the points of a mesh to the nodes of a regular grid: bilinear in four-sided
/// cells, linear in triangles. Vectors are carried along the great circle from point to node, so that meridians that
/// converge do not turn them.
/// Edges    a node outside every cell is missing, and so is one less than half of whose weight lies on points with
///          water; of cells that overlap the first counts
/// Threads  const members may be called from several threads at once
class Resampling {
 public:
  /// Errors  a mesh whose cells lie over one another many times over, as only damaged positions do
  [[nodiscard]] static Checked<std::shared_ptr<const Resampling>> of(const SourceMesh& mesh,
                                                                     const ocean::HorizontalGrid& grid);

  /// Shape  input: as the points; output: the grid [y][x]
  [[nodiscard]] VelocitySlice apply(std::span<const float> east, std::span<const float> north) const;
  /// The same of numbers without a direction.
  [[nodiscard]] std::vector<float> apply(std::span<const float> values) const;

 private:
  /// One node: its points and, for each, its weight times the cosine and the sine of the turn to the node.
  struct Stencil {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4> along{};
    std::array<float, 4> across{};
  };

  explicit Resampling(std::size_t nodes) : stencils_(nodes) {}
  void add(const SourceMesh& mesh, const SourceMesh::Cell& cell, const ocean::HorizontalGrid& grid,
           const NodeBox& box);

  std::vector<Stencil> stencils_;
};

/// How far stored slices differ from their source: each is interpolated back to the points of the source and compared
/// there. A point whose surroundings were not stored does not count.
class ResamplingError {
 public:
  void add(const SourceMesh& mesh, const VelocitySlice& source, const ocean::HorizontalGrid& grid,
           const VelocitySlice& stored);

  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] double rms_m_s() const;
  [[nodiscard]] double largest_m_s() const { return largest_m_s_; }
  [[nodiscard]] double rms_speed_m_s() const;  // of the source, to compare with

 private:
  double squares_{};
  double speeds_{};
  double largest_m_s_{};
  std::size_t points_{};
};

}  // namespace floeplan::ingest
