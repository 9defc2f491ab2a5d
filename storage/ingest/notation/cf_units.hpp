#pragma once

#include <optional>
#include <string_view>

namespace floeplan::ingest {

/// Metres per second per unit, for all usual spellings of a speed's unit: "m s-1", "ms-1", "m/s",
/// "meter second-1", "meters/second", "cm/s", "km/h", "knots".
/// Outside  nullopt for a unit that is not a speed or not known
[[nodiscard]] std::optional<double> speed_factor(std::string_view unit);

/// Metres per unit: "m", "metres", "METERS", "km", "feet", "fathoms", ...; also multiples, as "100 km" in the
/// Arctic products of Copernicus.
/// Outside  nullopt for a unit that is not a length or not known
[[nodiscard]] std::optional<double> length_factor(std::string_view unit);

/// Whether a unit is one of pressure: "hPa", "dbar", "millibars".
[[nodiscard]] bool is_pressure_unit(std::string_view unit);

/// Degrees along meridians or parallels in the spellings of the CF conventions: "degrees_east", "degree_E",
/// "degreesE".
[[nodiscard]] bool is_degrees_east(std::string_view unit);
[[nodiscard]] bool is_degrees_north(std::string_view unit);

}  // namespace floeplan::ingest
