#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/repository/fields/field_chunks.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// How samples at a model's own points are stored: a block of points is a chunk whose rows are 64 points each.
struct NativeLayout {
  ChunkLayout chunks;
  std::size_t points{};
  std::size_t
      bed_levels{};  // that follow the sea bed, whose depths are stored, too; 0: the depths of the grid
};

/// nullopt: the dataset's samples are on its grid.
[[nodiscard]] std::optional<NativeLayout> find_native_layout(sql::Connection& db, std::int64_t dataset_row);

/// Whether an area is a place.
[[nodiscard]] bool is_one_place(const geo::BoundingBox& area);

/// The nodes at which the values of a part of a mesh are interpolated when they are read: the nodes of the
/// dataset's lattice about the area, refined where the model is finer. For an area without extent the only
/// node is that place, so a point of the model has the model's own value.
[[nodiscard]] ocean::HorizontalGrid nodes_of_use(const geo::BoundingBox& area,
                                                 const ocean::HorizontalGrid& lattice,
                                                 const ocean::Mesh& part);

/// Errors  sql::Failure (damaged): cells that lie over one another are never stored
[[noreturn]] void refuse_overlapping_cells();
/// Errors  as refuse_overlapping_cells
[[nodiscard]] ocean::MeshSampling sampling_of(const ocean::Mesh& part, const ocean::HorizontalGrid& nodes);

/// Reads the samples of a part of a mesh, which it borrows.
/// Threads  as the connection: one thread at a time
class PointReader {
 public:
  PointReader(sql::Connection& db, const NativeLayout& layout, const MeshPart& part);

  /// Shape  [point] of the part, NaN where missing
  [[nodiscard]] std::vector<float> read(const SliceKey& slice);

 private:
  ChunkReader chunks_;
  std::size_t points_;
  std::vector<GridWindow> blocks_;
};

}  // namespace floeplan::repository
