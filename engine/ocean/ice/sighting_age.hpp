#pragma once

#include "engine/core/units.hpp"

namespace floeplan::ocean {

/// Icebergs last seen longer ago than this are left out unless a request says otherwise: forecasts of their drift lose
/// about 0.75 km an hour (C-CORE hindcast of 340 displacements, 2023-24), 50 km in this time.
inline constexpr core::Seconds max_sighting_age{3.0 * 86400.0};

/// Those left out are told as a danger when last seen less than this ago, or first seen less than this after the last
/// moment that counts; older ones where nothing newer is known. Chosen: daily lists name a lasting berg again and again.
inline constexpr core::Seconds left_out_are_told{30.0 * 86400.0};

/// The one rule for the age of sightings, in plans, checks, the map, probes and exports. Of each iceberg the newest sighting up
/// to the moment `as_of` is used. It counts for a departure at `depart`, however long the mission is, if it is not earlier
/// than `oldest_that_counts(as_of, depart, max_age)`. The age is that at the departure, or at `as_of` where that is earlier.
/// Ages count in whole UTC days, because feeds often give only the day of a sighting: the whole day on which the largest age
/// falls still counts.
[[nodiscard]] core::UtcTime oldest_that_counts(core::UtcTime as_of, core::UtcTime depart,
                                               core::Seconds max_age);

/// The same rule from the sighting's side: the first departure for which it is too old, whatever is known then.
[[nodiscard]] core::UtcTime too_old_from(core::UtcTime observed, core::Seconds max_age);

}  // namespace floeplan::ocean
