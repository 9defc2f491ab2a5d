#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::routes {

/// Reference systems in which features can be requested (OGC API - Features, Part 2).
enum class FeatureCrs {
  crs84,         // longitude, latitude in degrees
  epsg4326,      // latitude, longitude in degrees
  web_mercator,  // EPSG:3857, metres east and north
};

/// URIs of the reference systems. The first is the one in which features are stored, and the default.
[[nodiscard]] const std::vector<std::string>& crs_uris();
/// The reference system with this URI, or with a short name that clients use: "CRS84", "CRS:84", "OGC:CRS84",
/// "EPSG:4326", "EPSG:3857". The whole service reads names of reference systems with this function, so that
/// the order of axes is the same everywhere.
[[nodiscard]] std::optional<FeatureCrs> parse_crs(const std::string& name);
[[nodiscard]] const std::string& uri_of(FeatureCrs crs);

/// A position in the order and unit of a reference system; conversion to it and back.
/// Source  IOGP Guidance Note 373-7-2, method 1024 (Popular Visualisation Pseudo-Mercator)
struct Coordinates {
  double first{};
  double second{};
};
[[nodiscard]] Coordinates from_lon_lat(geo::LonLat place, FeatureCrs crs);
[[nodiscard]] geo::LonLat to_lon_lat(Coordinates coordinates, FeatureCrs crs);

/// Converts the positions of a GeoJSON geometry (or null) from CRS84 to the reference system.
void express_in(nlohmann::json& geometry, FeatureCrs crs);

}  // namespace floeplan::routes
