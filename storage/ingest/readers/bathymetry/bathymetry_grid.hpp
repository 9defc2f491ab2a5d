#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/grids/raw_rows.hpp"
#include "storage/ingest/readers/bathymetry/vertical_sense.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"

namespace floeplan::ingest {

/// Depths or elevations in a file, before it is known which of both they are. They are read a band at a time, because
/// charts of an ocean do not fit into the memory of a reading process.
struct RawBathymetry {
  ocean::HorizontalGrid grid;
  /// A model's own points, at which the depths are kept, one to a row; empty: they lie at the grid's nodes.
  std::optional<repository::MeshInBlocks> own_points{};
  VerticalDescription description;
  Messages warnings;
  /// Reads some rows, from a first row on. With several bands each row is read twice.
  std::function<Checked<RawRows>(std::size_t first_row, std::size_t rows)> read;
};

/// Hands out rows that are all in memory.
[[nodiscard]] std::function<Checked<RawRows>(std::size_t, std::size_t)> rows_in_memory(RawRows all,
                                                                                       std::size_t columns);

/// The bed may lie higher or lower than measured by as much as the measurement may be wrong.
/// `uncertainty_m`  as the values; not above 0, or above 1000: not known
void widen(RawRows& rows, const std::vector<float>& uncertainty_m);

/// Decides the sense, leaves out markers for "missing" that the file does not declare, and checks the extent.
/// Errors   nothing but missing values; deeper than 12000 m or higher than 9000 m; sense unknown; those of `read`
[[nodiscard]] Checked<PreparedDataset> prepare_bathymetry(RawBathymetry raw,
                                                          const std::optional<std::string>& positive);

}  // namespace floeplan::ingest
