#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// A mesh renumbered so that the points of each block are close together, with the points' earlier numbers.
struct MeshInBlocks {
  ocean::Mesh mesh;
  std::vector<std::uint32_t> sources;  // earlier number of each point

  /// The values of the points; `values` are those of the points by their earlier numbers.
  [[nodiscard]] std::vector<float> in_order(std::span<const float> values) const;
};

/// Renumbers the points along a curve that fills the globe. Points that belong to no cell are dropped.
/// Source  Hilbert 1891, on the octahedral map of the sphere (Engelhardt and Dachsbacher 2008, section 3)
[[nodiscard]] MeshInBlocks in_blocks(const ocean::Mesh& mesh);

/// Blocks of a mesh that are read together.
struct MeshPart {
  ocean::Mesh mesh;                 // its points are those of the blocks, block after block
  std::vector<std::size_t> blocks;  // numbers of the blocks, ascending
};

/// Points and cells of the meshes on which fields are stored. They are stored in blocks of neighbouring
/// points, so that reading an area reads only some blocks.
/// Threads  as the connection: one thread at a time
class MeshBlocks {
 public:
  /// Number of points in a block; the same as the samples in a chunk of a grid.
  static constexpr std::size_t points_together = 4096;

  explicit MeshBlocks(sql::Connection& db) : db_{db} {}

  /// Precondition  the points were numbered by `in_blocks`
  void write(std::int64_t dataset_row, const ocean::Mesh& mesh);
  /// The cells in an area with all cells that they depend on, and some more around; empty if there are none.
  /// Errors  sql::Failure (damaged) when a cell refers to a point that does not exist
  [[nodiscard]] MeshPart around(std::int64_t dataset_row, const geo::BoundingBox& area) const;
  /// About the number of points that `around` returns, found without reading them.
  [[nodiscard]] std::size_t points_around(std::int64_t dataset_row, const geo::BoundingBox& area) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
