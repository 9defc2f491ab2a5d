#pragma once

#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"

namespace floeplan::planning::obstacles {

/// Expected place of an iceberg at a time after the epoch, and its position error.
struct TrackPoint {
  double t_s{};
  geo::PlanePoint centre;
  core::Metres error;  // expected, limited by the rules
  double scale{1.0};   // metres of the plane per metre on the ground there
};

/// The forecast of one iceberg from the epoch to the horizon. Between two points place and error change at a
/// constant rate. A single point if the berg stands.
/// Stops    early with fewer points once `stop` is requested
[[nodiscard]] std::vector<TrackPoint> track_of(const ocean::Iceberg& iceberg,
                                               const ocean::Environment& environment,
                                               const IcebergRules& rules,
                                               const geo::LocalProjection& projection, core::UtcTime epoch,
                                               core::Seconds horizon, const std::stop_token& stop = {});

}  // namespace floeplan::planning::obstacles
