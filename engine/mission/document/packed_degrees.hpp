#pragma once

#include <optional>
#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::mission {

/// An angle in the form of GliderDOS: sign x (100 x whole degrees + minutes) with four decimals of a minute
/// (0.19 m in latitude), for example -73.8 as "-7348.0000". At least four digits stand before the point, so
/// -0.5 is "-0030.0000".
/// Edges    minutes never read 60; zero has no sign; values that round to -180 are written as "18000.0000"
/// Errors   std::invalid_argument unless `angle_deg` is finite and within [-180, 180]
[[nodiscard]] std::string packed_degrees(double angle_deg);

/// A packed angle after reading.
struct UnpackedAngle {
  double degrees{};
  bool sixty_minutes{};  // minutes were 60 or more: defined, but no writer should produce it
};

/// The angle of a packed number. The sign applies to the whole: -30.5 is 30.5 minutes west.
[[nodiscard]] UnpackedAngle unpack_degrees(double packed);

/// The place with two packed coordinates.
/// Outside  nullopt for invalid places: a Slocum without a fix logs 69696969 or 69697000
[[nodiscard]] std::optional<geo::LonLat> unpack_place(double packed_lon, double packed_lat);

}  // namespace floeplan::mission
