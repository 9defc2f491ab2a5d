#pragma once

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// Largest age of a sighting unless a request says otherwise; older ones are left out. Drift forecasts lose
/// about 0.75 km per hour (C-CORE hindcast of 340 displacements, 2023-24), 50 km in this time.
inline constexpr core::Seconds max_sighting_age{3.0 * 86400.0};

/// The largest age that a request may ask for. Our choice: after a month a drift forecast says nothing.
inline constexpr core::Seconds largest_sighting_age{30.0 * 86400.0};

/// Icebergs that are left out are reported as a danger if their sighting is less than this outside the
/// limits, before or after; older ones if nothing newer is known. Our choice: daily lists name a lasting berg
/// again and again.
inline constexpr core::Seconds left_out_are_told{30.0 * 86400.0};

/// The one rule for the age of sightings, in plans, checks, the map, probes and exports. Of each iceberg the
/// newest sighting up to the time `as_of` is used. For a departure at `depart` it counts if it is not earlier
/// than `oldest_that_counts(as_of, depart, max_age)`, however long the mission is. The age is taken at the
/// departure, or at `as_of` if that is earlier. Ages count in whole UTC days, because sources often give only
/// the day of a sighting: the whole day on which the largest age falls still counts.
[[nodiscard]] core::UtcTime oldest_that_counts(core::UtcTime as_of, core::UtcTime depart,
                                               core::Seconds max_age);

/// The first departure for which a sighting is too old by the same rule, whatever is known by then.
[[nodiscard]] core::UtcTime too_old_from(core::UtcTime observed, core::Seconds max_age);

}  // namespace floeplan::ocean
