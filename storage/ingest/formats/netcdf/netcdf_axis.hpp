#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_variable.hpp"

namespace floeplan::ingest {

/// What the values of a coordinate variable measure.
enum class AxisRole {
  longitude,
  latitude,
  depth,
  time,
  projected_x,
  projected_y,
  model_level,  // follows the sea bed; its depths come from a formula or a table
  other_level,  // no depth and no height: a pressure, a temperature, a number of a level, a height above the sea bed
  unknown
};

/// The role of a coordinate by its standard name, its unit, its axis attribute and, at last, its name.
[[nodiscard]] AxisRole role_of(const NetcdfVariable& coordinate);

/// Coordinates in ascending order and, for each, its index in the file.
struct AxisNodes {
  std::vector<double> nodes;
  std::vector<std::size_t> source;
};

/// Ascending longitudes, as the file counts them (-247, 20 to 380 stay); a step back across the seam is
/// unrolled, and a last column that repeats the first is left out.
[[nodiscard]] Checked<AxisNodes> longitude_nodes(const std::string& name, std::vector<double> values);
/// Ascending latitudes within [-90, 90].
[[nodiscard]] Checked<AxisNodes> latitude_nodes(const std::string& name, std::vector<double> values);
/// Ascending values of any other axis that runs up or down.
[[nodiscard]] Checked<AxisNodes> monotonic_nodes(const std::string& name, std::vector<double> values);
/// Ascending times in whatever order the file has them; equal times are refused.
[[nodiscard]] Checked<AxisNodes> sorted_nodes(const std::string& name, std::vector<double> values);

}  // namespace floeplan::ingest
