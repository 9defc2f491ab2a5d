#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace floeplan::ingest {

/// What moves: the sea, or the air 10 m above it.
enum class Moving { sea, air };

/// Whether wind that is known at this height is the one 10 m above the sea.
[[nodiscard]] inline bool is_height_of_wind(double height_m) { return std::abs(height_m - 10.0) <= 0.5; }

/// What the two components of a velocity are measured along.
enum class VelocityAxes {
  east_north,  // true east and true north
  grid,        // the axes of the model's grid
  unstated     // the file does not say
};

/// Which of its two components a variable is.
enum class Component {
  first,  // towards east, or along the grid's first axis
  second
};

/// How much of the motion of the water a velocity holds.
enum class CurrentContent {
  whole,         // nothing to the contrary is said
  total,         // the tide, too, and perhaps the drift by waves
  without_tide,  // all but the tide
  geostrophic,   // what the slope of the sea's surface tells
  tide,          // nothing but the tide
  wave_drift,    // nothing but the drift by waves (Stokes)
  other_part     // another part: Ekman, baroclinic, of eddies
};

/// Which water a velocity without levels of its own is of.
enum class WaterPart { unstated, surface, column_mean, bed };

/// The names of the components to use where a file holds several pairs, as the user gives them: one, or both with a
/// comma between. Names that belong to no velocity of the file are those of other data.
using WantedVariables = std::optional<std::string>;

}  // namespace floeplan::ingest
