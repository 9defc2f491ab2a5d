#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"

namespace floeplan::planning::obstacles {

/// Where an iceberg is expected at a time after the epoch and how far from there it may be.
struct TrackPoint {
  double t_s{};
  geo::PlanePoint centre;
  core::Metres error;  // expected, capped by the rules
  double scale{1.0};   // of the plane there
};

/// The forecast of one iceberg from the epoch to the horizon; between two points centre and error change evenly.
/// One point alone when it stands.
/// Stops    early with fewer points once `stop` is requested
[[nodiscard]] std::vector<TrackPoint> track_of(const ocean::Iceberg& iceberg,
                                               const ocean::Environment& environment,
                                               const IcebergRules& rules,
                                               const geo::LocalProjection& projection, core::UtcTime epoch,
                                               core::Seconds horizon, const std::stop_token& stop = {});

}  // namespace floeplan::planning::obstacles
