#pragma once

#include <string>

namespace floeplan::mission {

/// Angle as GliderDOS reads it: sign x (100 x whole degrees + minutes) with four decimals of a minute
/// (0.19 m in latitude), e.g. -73.8 as "-7348.0000". At least four digits stand before the point, so -0.5 is
/// "-0030.0000".
/// Edges    the minutes never read 60; zero has no sign; what rounds to -180 is written as "18000.0000"
/// Errors   std::invalid_argument unless `angle_deg` is finite and within [-180, 180]
[[nodiscard]] std::string packed_degrees(double angle_deg);

}  // namespace floeplan::mission
