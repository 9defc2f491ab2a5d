#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/geo/grid_frame.hpp"
#include "engine/geo/lon_lat.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// The figure of the Earth of a CRS whose longitudes and latitudes can be used as those of WGS84: they differ by metres
/// only (on GRS 1980 and ellipsoids that differ as little), or they are on a sphere, and models that compute on a sphere mean the Earth's
/// latitudes.
/// Outside  nullopt for every other datum
[[nodiscard]] std::optional<geo::Ellipsoid> earth_of(const OGRSpatialReference& crs);

/// Longitudes and latitudes of the nodes of a grid in any reference system. Latitudes that can be used as those of WGS84
/// (`earth_of`) are taken on the system's own figure of the Earth, because the step from a sphere to
/// WGS84 would move them by up to 20 km; from all other datums PROJ transforms to WGS84.
/// `at`     coordinates of a node in `crs`, easting or longitude first
/// Shape    [row][column]; places outside the range of the projection are not finite
/// Errors   in PROJ's words: there is no transformation
[[nodiscard]] tl::expected<std::vector<geo::LonLat>, std::string> places_by_crs(
    const OGRSpatialReference& crs, std::size_t rows, std::size_t columns,
    const std::function<geo::GridPoint(std::size_t row, std::size_t column)>& at);

}  // namespace floeplan::ingest
