#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/horizontal_grid.hpp"
#include "storage/ingest/prepared_dataset.hpp"
#include "storage/ingest/vertical_sense.hpp"

namespace floeplan::ingest {

/// Depths or elevations as read from a file, before it is known which of both they are.
/// Shape    values_m is [y][x], y ascending; NaN where missing. lowest_m and highest_m are alike, or empty where no cell
///          reaches beyond its value: the range of all that is known of a node's cell
struct RawBathymetry {
  ocean::HorizontalGrid grid;
  std::vector<float> values_m;
  VerticalDescription description;
  std::vector<std::string> warnings;
  std::vector<float> lowest_m{};
  std::vector<float> highest_m{};
};

/// Decides the sense, leaves out markers for "missing" that the file does not declare, and checks the extent.
/// Errors   nothing but missing values; deeper than 12000 m or higher than 9000 m; sense unknown
[[nodiscard]] Checked<PreparedDataset> prepare_bathymetry(RawBathymetry raw,
                                                          const std::optional<std::string>& positive);

}  // namespace floeplan::ingest
