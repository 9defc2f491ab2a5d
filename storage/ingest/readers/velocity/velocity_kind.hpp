#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace floeplan::ingest {

/// The moving medium: the sea, or the air 10 m above it.
enum class Moving { sea, air };

/// Whether wind at this height counts as wind 10 m above the sea.
[[nodiscard]] inline bool is_height_of_wind(double height_m) { return std::abs(height_m - 10.0) <= 0.5; }

/// The axes along which a velocity's two components point.
enum class VelocityAxes {
  east_north,  // true east and true north
  grid,        // the axes of the model's grid
  unstated     // the file does not say
};

/// Which component of a velocity a variable is.
enum class Component {
  first,  // towards east, or along the grid's first axis
  second
};

/// The part of the water's motion that a velocity contains.
enum class CurrentContent {
  whole,         // the file mentions no part
  total,         // includes the tide, and perhaps the drift by waves
  without_tide,  // everything except the tide
  geostrophic,   // the current that balances the slope of the sea surface
  tide,          // only the tide
  wave_drift,    // only the drift by waves (Stokes drift)
  other_part     // another part: Ekman, baroclinic, eddies
};

/// Where in the water column a velocity without levels is.
enum class WaterPart { unstated, surface, column_mean, bed };

/// The user's choice of components if a file has several pairs: one name, or both separated by a comma. Names
/// that are no velocity of the file refer to other data.
using WantedVariables = std::optional<std::string>;

}  // namespace floeplan::ingest
