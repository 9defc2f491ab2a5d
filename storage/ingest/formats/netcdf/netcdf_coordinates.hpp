#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The coordinate variable of a dimension: normally the one-dimensional variable with the dimension's name.
/// If there is none, or it does not say what it measures, the only variable along the dimension that is a
/// coordinate by its standard name, axis or unit ("xgrid" along "x", OSCAR's "lat" along "latitude"). GDAL's
/// own indexing variable is not used: it may be a two-dimensional table or belong to the other axis.
/// Returns  null when there is none
[[nodiscard]] const NetcdfVariable* coordinate_of(const NetcdfFile& file, const NetcdfDimension& dimension);

/// A table with the height of each level at every point, so that the dimension of the levels needs no
/// coordinate variable: SCHISM's zcor (zCoordinates in newer files); null if there is none.
[[nodiscard]] const NetcdfVariable* heights_along(const NetcdfFile& file, const NetcdfDimension& levels);

/// Depths in metres, positive down, ascending. The file may count up or down, in any unit of length.
[[nodiscard]] Checked<AxisNodes> depth_nodes(const NetcdfVariable& coordinate, Messages& warnings);

/// Seconds since 1970-01-01T00:00:00Z, ascending.
[[nodiscard]] Checked<AxisNodes> time_nodes(const NetcdfVariable& coordinate, Messages& warnings);

/// A time that the file states once for all its data; null if there is none.
[[nodiscard]] const NetcdfVariable* scalar_time(const NetcdfFile& file);

/// Whether the levels have the role other_level, so that values on them have no known depth. A single level
/// that is only a number ("level = 1") does not count as one.
[[nodiscard]] bool cannot_be_placed(const NetcdfVariable& levels);
/// The refusal of a variable on such levels.
[[nodiscard]] messages::Message not_in_metres(const NetcdfVariable& levels, const std::string& variable);

/// A single depth, height or other level that applies to all of a variable: one of its (or the file's)
/// `coordinates`, or the only scalar of the file that is a level by its standard name or axis.
/// Returns  null when there is none
[[nodiscard]] const NetcdfVariable* level_beside(const NetcdfFile& file, const NetcdfVariable& variable);

/// Coordinates of a projection in metres, ascending.
[[nodiscard]] Checked<AxisNodes> projected_nodes(const NetcdfVariable& coordinate, Messages& warnings);

}  // namespace floeplan::ingest
