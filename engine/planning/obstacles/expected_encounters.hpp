#pragma once

#include <cmath>

#include "engine/core/units.hpp"
#include "engine/motion/disc_encounter.hpp"
#include "engine/planning/obstacles/drifting_disc.hpp"

namespace floeplan::planning::obstacles {

/// How well the position of an iceberg is known: the mean error grows evenly with the time from its sighting.
/// Units    metres of the plane; times count from the epoch of the forecast
struct PositionError {
  double at_sighting_m{};
  double growth_m_s{};
  double sighted_s{};

  [[nodiscard]] double mean_m(double t_s) const {
    return at_sighting_m + growth_m_s * std::abs(t_s - sighted_s);
  }
};

/// How often, on the average over the errors of its position, a vehicle on this move comes within the margin of the
/// iceberg's hull. The error counts in full, not only up to the most that widens the disc, and is taken as normal and
/// alike in all directions about the forecast.
/// `passed_under`: the iceberg is not met while the vehicle is in its disc
[[nodiscard]] double expected_encounters(const DriftingDisc& iceberg, const PositionError& error,
                                         bool passed_under, const motion::EvenMove& move);

/// The same for each second at a point, for a vehicle of this speed past an iceberg that stands; the position counts
/// as known no better than to `blur`.
[[nodiscard]] double encounter_rate(const DriftingDisc& iceberg, const PositionError& error,
                                    bool passed_under, geo::PlanePoint point, core::Seconds time,
                                    core::MetresPerSecond speed, core::Metres blur);

}  // namespace floeplan::planning::obstacles
