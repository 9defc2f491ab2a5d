#pragma once

#include <optional>
#include <tuple>

namespace floeplan::geo {

/// A place on the WGS84 ellipsoid, degrees, east and north positive. Longitude first, everywhere.
struct LonLat {
  double lon_deg{};
  double lat_deg{};

  friend bool operator==(LonLat, LonLat) = default;
  /// For core::packed.
  friend auto members_of(LonLat& place) {
    auto& [lon_deg, lat_deg] = place;
    return std::tie(lon_deg, lat_deg);
  }
};

/// The longitude wrapped to [-180, 180).
[[nodiscard]] double wrap_longitude(double lon_deg);

/// Signed difference `to - from` of two longitudes, the short way round, in [-180, 180).
[[nodiscard]] double longitude_difference(double from_deg, double to_deg);

/// Whether both are finite, the latitude is within [-90, 90] and the longitude within [-180, 360].
[[nodiscard]] bool is_valid(LonLat place);

}  // namespace floeplan::geo
