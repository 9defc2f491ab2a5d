#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// The reference system that a file states for a variable; null if there is none or it cannot be read.
[[nodiscard]] std::shared_ptr<const OGRSpatialReference> projection_of(const NetcdfFile& file,
                                                                       const NetcdfVariable& variable);

/// Whether the two dimensions are axes of a projection or of rotated longitudes and latitudes, so that the
/// position of every point can be computed. The store itself has no grids of this kind.
[[nodiscard]] bool is_placed_by_projection(const NetcdfFile& file, const NetcdfVariable& variable,
                                           std::size_t y_dimension, std::size_t x_dimension);

/// The positions of all points over these two dimensions (`places_by_crs`).
/// Shape    [y][x], in the order of the file; a point outside the range of the projection is not finite
/// Errors   the coordinates are damaged or are not lengths; there are more points than this program accepts
[[nodiscard]] Checked<std::vector<geo::LonLat>> places_by_projection(const NetcdfFile& file,
                                                                     const NetcdfVariable& variable,
                                                                     std::size_t y_dimension,
                                                                     std::size_t x_dimension);

}  // namespace floeplan::ingest
