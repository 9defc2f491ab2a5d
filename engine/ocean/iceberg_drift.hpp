#pragma once

#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/ocean/ice/iceberg.hpp"

namespace floeplan::ocean {

/// Where an iceberg is expected: hour by hour from its sighting to the end of the forecast, counted anew where the
/// currents or the wind begin or end. Between two fixes it moves straight and evenly.
/// Drift    the currents' mean over its draft, what the wind adds to that where it is known, and what it moved faster
///          or slower than both between its last two sightings: errors of the data, and the wind where none is
///          given, which fade within a day. The fixes come by the midpoint rule, which follows a tide to about one
///          hundredth of its amplitude
/// Edges    where or when the currents are not known: as it moved between its last two sightings; without earlier
///          ones before the wind alone, and without wind it stays. Where the wind is known now but was not between
///          the sightings, what they show beside the current was wind, too, and is not counted twice. Where the
///          sea bed is not deeper than its draft it is aground and stays until the drift leads to deeper water.
///          `until` before the sighting: the sighting alone
/// Stops    early with fewer fixes once `stop` is requested
/// Source   Wagner, Dell and Eisenman 2017, An analytical model of iceberg drift, J. Phys. Oceanogr. 47: an iceberg
///          moves with the water that carries it and against it as `moved_by_wind` has it
[[nodiscard]] std::vector<IcebergFix> forecast_drift(const Iceberg& iceberg, const Environment& environment,
                                                     core::UtcTime until, const std::stop_token& stop = {});

/// The time from which a forecast needs currents and wind: that of the earlier sighting that shows the iceberg's drift,
/// or else the last one.
[[nodiscard]] core::UtcTime forecast_needs_from(const Iceberg& iceberg);

/// Whether the current is known everywhere on the forecast between two times, but for where the iceberg is
/// aground.
[[nodiscard]] bool is_current_known(const Iceberg& iceberg, const Environment& environment,
                                    core::UtcTime from, core::UtcTime until,
                                    const std::stop_token& stop = {});

/// The data on which an iceberg's forecast rests.
struct DriftBasis {
  core::Seconds unknown{0.0};  // without a known current, and not aground
  std::vector<IcebergFix>
      known;  // the longest part of the forecast with a known current all along, or aground
};

/// The data of the forecast from the sighting to `until` or a little later, hour by hour. A current that is known
/// when an hour begins counts as known in that hour.
[[nodiscard]] DriftBasis drift_basis(const Iceberg& iceberg, const Environment& environment,
                                     core::UtcTime until, const std::stop_token& stop = {});

/// How far from its forecast an iceberg may be expected: what the source states, and 0.75 km more for each hour
/// before or after the sighting.
/// Source   C-CORE hindcast of 340 displacements on the Grand Banks 2023-24: mean error 8.8 km after 12 h,
///          18.1 km after 24 h
[[nodiscard]] core::Metres expected_error(const Iceberg& iceberg, core::UtcTime time);

/// The growth in `expected_error`.
inline constexpr core::MetresPerSecond error_growth{750.0 / 3600.0};

}  // namespace floeplan::ocean
