#pragma once

#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/ocean/ice/iceberg.hpp"

namespace floeplan::ocean {

/// The expected places of an iceberg: hour by hour from its sighting to the end of the forecast, with a new
/// count of hours where currents or wind begin or end. Between two fixes it moves straight at constant speed.
/// Drift    The sum of the mean current over its draft, the effect of the wind, if known, and a remainder. The
///          remainder is the velocity between its last two sightings minus current and wind then. It contains
///          errors of the data, and the wind if that is unknown; it fades within a day. The sum is integrated by
///          the midpoint rule, which follows a tide to about one hundredth of its amplitude
/// Edges    Where currents are unknown the berg moves as between its last two sightings; without earlier
///          sightings it moves with the wind alone, and without wind it stays. If the wind is known now but
///          was not between the sightings, the remainder contains wind and is not added. Where the sea bed is
///          not deeper than its draft the berg is aground, and stays until the drift leads to deeper water.
///          `until` before the sighting: only the sighting
/// Stops    early with fewer fixes once `stop` is requested
/// Source   Wagner, Dell and Eisenman 2017, An analytical model of iceberg drift, J. Phys. Oceanogr. 47: an
///          iceberg moves with the water that carries it, and relative to it as by `moved_by_wind`
[[nodiscard]] std::vector<IcebergFix> forecast_drift(const Iceberg& iceberg, const Environment& environment,
                                                     core::UtcTime until, const std::stop_token& stop = {});

/// The time from which a forecast needs currents and wind: the earlier sighting that shows the drift,
/// otherwise the last one.
[[nodiscard]] core::UtcTime forecast_needs_from(const Iceberg& iceberg);

/// Whether the current is known all along the forecast between two times, except where the iceberg is
/// aground.
[[nodiscard]] bool is_current_known(const Iceberg& iceberg, const Environment& environment,
                                    core::UtcTime from, core::UtcTime until,
                                    const std::stop_token& stop = {});

/// The data that an iceberg's forecast is based on.
struct DriftBasis {
  core::Seconds unknown{0.0};  // time without a known current, and not aground
  std::vector<IcebergFix>
      known;  // longest part of the forecast in which the current is always known or the berg aground
};

/// The data of the forecast from the sighting to `until` or slightly later, hour by hour. A current that is
/// known at the beginning of an hour counts as known in that hour.
[[nodiscard]] DriftBasis drift_basis(const Iceberg& iceberg, const Environment& environment,
                                     core::UtcTime until, const std::stop_token& stop = {});

/// Expected position error of the forecast: what the source states, and 0.75 km more for each hour before or
/// after the sighting.
/// Source   C-CORE hindcast of 340 displacements on the Grand Banks 2023-24: mean error 8.8 km after 12 h,
///          18.1 km after 24 h
[[nodiscard]] core::Metres expected_error(const Iceberg& iceberg, core::UtcTime time);

/// Growth rate of `expected_error`: 750 m per hour.
inline constexpr core::MetresPerSecond error_growth{750.0 / 3600.0};

}  // namespace floeplan::ocean
