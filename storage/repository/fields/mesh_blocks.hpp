#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// A mesh whose points are numbered so that those of a block lie together, and how they were numbered before.
struct MeshInBlocks {
  ocean::Mesh mesh;
  std::vector<std::uint32_t> sources;  // of each point: its number before
};

/// Numbers the points along a curve that fills the globe, leaving out those that no cell has.
/// Source  Hilbert 1891, on the octahedral map of the sphere (Engelhardt and Dachsbacher 2008, section 3)
[[nodiscard]] MeshInBlocks in_blocks(const ocean::Mesh& mesh);

/// The blocks of a mesh that are read together.
struct MeshPart {
  ocean::Mesh mesh;                 // its points are those of the blocks, one after the other
  std::vector<std::size_t> blocks;  // ascending
};

/// Points and cells of the meshes on which fields are stored, in blocks of points that lie together, so that an area
/// reads its part alone.
/// Threads  as the connection: one thread at a time
class MeshBlocks {
 public:
  /// Points of one block: as many as a chunk of samples on a grid has.
  static constexpr std::size_t points_together = 4096;

  explicit MeshBlocks(sql::Connection& db) : db_{db} {}

  /// Precondition  points numbered by `in_blocks`
  void write(std::int64_t dataset_row, const ocean::Mesh& mesh);
  /// The cells in an area, with all those round it on which they depend, and some more; empty where there are none.
  /// Errors  sql::Failure (damaged) for numbers that no point has
  [[nodiscard]] MeshPart around(std::int64_t dataset_row, const geo::BoundingBox& area) const;
  /// About how many points they have, without reading them.
  [[nodiscard]] std::size_t points_around(std::int64_t dataset_row, const geo::BoundingBox& area) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
