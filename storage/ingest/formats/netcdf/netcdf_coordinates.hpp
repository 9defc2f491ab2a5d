#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The coordinate variable of a dimension: one-dimensional and of the dimension's own name; where nothing has that
/// name, or what has it does not say what it measures, the only variable along it that standard name, axis or unit make a coordinate ("xgrid" along "x", OSCAR's
/// "lat" along "latitude"). GDAL's own indexing variable is not asked: it may be a two-dimensional table or belong to
/// the other axis.
/// Returns  null when there is none
[[nodiscard]] const NetcdfVariable* coordinate_of(const NetcdfFile& file, const NetcdfDimension& dimension);

/// A table of the heights of levels along a dimension at every point, which then needs no coordinate variable: SCHISM's
/// zcor (zCoordinates in its newer files); null when there is none.
[[nodiscard]] const NetcdfVariable* heights_along(const NetcdfFile& file, const NetcdfDimension& levels);

/// Depths in metres, positive down and ascending, whichever way and in whichever unit of length the file counts.
[[nodiscard]] Checked<AxisNodes> depth_nodes(const NetcdfVariable& coordinate, Messages& warnings);

/// Seconds since 1970-01-01T00:00:00Z, ascending.
[[nodiscard]] Checked<AxisNodes> time_nodes(const NetcdfVariable& coordinate, Messages& warnings);

/// A time that the file states once for all its data; null when there is none.
[[nodiscard]] const NetcdfVariable* scalar_time(const NetcdfFile& file);

/// Whether levels are of the role other_level, so that what lies on them cannot be placed. A single level with a number
/// alone ("level = 1") says nothing, neither this.
[[nodiscard]] bool cannot_be_placed(const NetcdfVariable& levels);
/// Why a variable on such levels is refused.
[[nodiscard]] messages::Message not_in_metres(const NetcdfVariable& levels, const std::string& variable);

/// A single depth, height or other level that holds for all of a variable: one of its `coordinates` (or of the file's), or
/// the only scalar of the file that its standard name or axis makes a level.
/// Returns  null when there is none
[[nodiscard]] const NetcdfVariable* level_beside(const NetcdfFile& file, const NetcdfVariable& variable);

/// Coordinates of a projection in metres, ascending.
[[nodiscard]] Checked<AxisNodes> projected_nodes(const NetcdfVariable& coordinate, Messages& warnings);

}  // namespace floeplan::ingest
