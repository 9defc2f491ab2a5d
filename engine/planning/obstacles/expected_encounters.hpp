#pragma once

#include <cmath>

#include "engine/core/units.hpp"
#include "engine/motion/disc_encounter.hpp"
#include "engine/planning/obstacles/drifting_disc.hpp"

namespace floeplan::planning::obstacles {

/// Position error of an iceberg: its mean grows at a constant rate with the time from the sighting.
/// Units    metres of the plane; times count from the epoch of the forecast
struct PositionError {
  double at_sighting_m{};
  double growth_m_s{};
  double sighted_s{};

  [[nodiscard]] double mean_m(double t_s) const {
    return at_sighting_m + growth_m_s * std::abs(t_s - sighted_s);
  }
};

/// Expected number of times that a vehicle on this move comes within the margin of the iceberg's hull,
/// averaged over the position error. The whole error counts, not only the part that widens the disc. It is
/// taken as normal and equal in all directions around the forecast place.
/// `passed_under`: true: the iceberg is not met while the vehicle is inside its disc
[[nodiscard]] double expected_encounters(const DriftingDisc& iceberg, const PositionError& error,
                                         bool passed_under, const motion::EvenMove& move);

/// Expected encounters per second at a point, for a vehicle of this speed and an iceberg that stands. The
/// standard deviation of the position counts as at least `blur`.
[[nodiscard]] double encounter_rate(const DriftingDisc& iceberg, const PositionError& error,
                                    bool passed_under, geo::PlanePoint point, core::Seconds time,
                                    core::MetresPerSecond speed, core::Metres blur);

}  // namespace floeplan::planning::obstacles
