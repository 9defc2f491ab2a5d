#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_variable.hpp"

namespace floeplan::ingest {

/// The quantity that a coordinate variable holds.
enum class AxisRole {
  longitude,
  latitude,
  depth,
  time,
  projected_x,
  projected_y,
  model_level,  // follows the sea bed; its depths come from a formula or a table
  // not a depth or height: a pressure, a temperature, a level number, a height above the sea bed
  other_level,
  unknown
};

/// The role of a coordinate: found by its standard name, unit, axis attribute and, last, its name.
[[nodiscard]] AxisRole role_of(const NetcdfVariable& coordinate);

/// Coordinates in ascending order and, for each, its index in the file.
struct AxisNodes {
  std::vector<double> nodes;
  std::vector<std::size_t> source;
};

/// Ascending longitudes in the file's own range (-247, or 20 to 380, stay as they are). A jump back at the
/// seam is unwrapped, and a last column that repeats the first is dropped.
[[nodiscard]] Checked<AxisNodes> longitude_nodes(const std::string& name, std::vector<double> values);
/// Ascending latitudes within [-90, 90].
[[nodiscard]] Checked<AxisNodes> latitude_nodes(const std::string& name, std::vector<double> values);
/// Ascending values of any other axis, whose values in the file ascend or descend.
[[nodiscard]] Checked<AxisNodes> monotonic_nodes(const std::string& name, std::vector<double> values);
/// Ascending times; the file may have them in any order, but equal times are refused.
[[nodiscard]] Checked<AxisNodes> sorted_nodes(const std::string& name, std::vector<double> values);

}  // namespace floeplan::ingest
