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

/// The reference system that a file states for a variable; null: none that can be read.
[[nodiscard]] std::shared_ptr<const OGRSpatialReference> projection_of(const NetcdfFile& file,
                                                                       const NetcdfVariable& variable);

/// Whether the two dimensions are axes of a projection, or of turned longitudes and latitudes, from which longitude and
/// latitude of every point can be computed although no grid of the store lies so.
[[nodiscard]] bool is_placed_by_projection(const NetcdfFile& file, const NetcdfVariable& variable,
                                           std::size_t y_dimension, std::size_t x_dimension);

/// The places of all points of such a plane. Latitudes of a sphere are taken for those of the Earth, as models that
/// compute on one mean them.
/// Shape    [y][x], as the file has them; a point that the projection does not reach is not finite
/// Errors   coordinates that are damaged or no lengths; more points than this program accepts
[[nodiscard]] Checked<std::vector<geo::LonLat>> places_by_projection(const NetcdfFile& file,
                                                                     const NetcdfVariable& variable,
                                                                     std::size_t y_dimension,
                                                                     std::size_t x_dimension);

}  // namespace floeplan::ingest
