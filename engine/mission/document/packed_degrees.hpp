#pragma once

#include <optional>
#include <string>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::mission {

/// Angle as GliderDOS reads it: sign x (100 x whole degrees + minutes) with four decimals of a minute
/// (0.19 m in latitude), e.g. -73.8 as "-7348.0000". At least four digits stand before the point, so -0.5 is
/// "-0030.0000".
/// Edges    the minutes never read 60; zero has no sign; what rounds to -180 is written as "18000.0000"
/// Errors   std::invalid_argument unless `angle_deg` is finite and within [-180, 180]
[[nodiscard]] std::string packed_degrees(double angle_deg);

/// A packed angle that was read.
struct UnpackedAngle {
  double degrees{};
  bool sixty_minutes{};  // the minutes were 60 or more: defined, yet no writer should produce it
};

/// The angle of a packed number; the sign belongs to all of it, so -30.5 is half a degree and a bit west.
[[nodiscard]] UnpackedAngle unpack_degrees(double packed);

/// The place of two packed angles.
/// Outside  nullopt for what is no place: a Slocum that has no fix logs 69696969 or 69697000
[[nodiscard]] std::optional<geo::LonLat> unpack_place(double packed_lon, double packed_lat);

}  // namespace floeplan::mission
