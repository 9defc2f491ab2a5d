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

/// The depths or elevations of a file; which of the two they are is not yet known. They are read in bands of
/// rows, because an ocean's grid does not fit into the memory of a reading process.
struct RawBathymetry {
  ocean::HorizontalGrid grid;
  /// Points of their own, at which the depths are kept, one to a row; empty: they lie at the grid's nodes.
  std::optional<repository::MeshInBlocks> own_points{};
  VerticalDescription description;
  Messages warnings;
  /// Reads some rows, from a first row on. With several bands each row is read twice.
  std::function<Checked<RawRows>(std::size_t first_row, std::size_t rows)> read;
};

/// A function that returns rows from `all`, which is in memory.
[[nodiscard]] std::function<Checked<RawRows>(std::size_t, std::size_t)> rows_in_memory(RawRows all,
                                                                                       std::size_t columns);

/// Widens the range of each cell by the uncertainty of its value, so that the bed may lie higher or lower by
/// this much.
/// `uncertainty_m`  same shape as the values; values up to 0 and above 1000 count as unknown
void widen(RawRows& rows, const std::vector<float>& uncertainty_m);

/// Finds whether the values are depths or elevations, removes marks of missing values that the file does not
/// declare, and checks the range.
/// Errors   all values missing; deeper than 12000 m or higher than 9000 m; depth or elevation unknown; those
///          of `read`
[[nodiscard]] Checked<PreparedDataset> prepare_bathymetry(RawBathymetry raw,
                                                          const std::optional<std::string>& positive);

}  // namespace floeplan::ingest
