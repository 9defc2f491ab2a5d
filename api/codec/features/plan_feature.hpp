#pragma once

#include <vector>

#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::codec {

/// A stored plan as a GeoJSON Feature (LineString; MultiLineString, cut at 180 degrees, where the route
/// crosses the antimeridian). Properties: the plan document, name and created.
/// Errors   std::runtime_error when the stored document is not a plan
[[nodiscard]] nlohmann::json plan_feature(const repository::PlanRecord& plan);

/// A leg or a waypoint of a plan as a Feature, with the period and the box that list filters use.
struct PlanPart {
  nlohmann::json feature;
  core::UtcTime begin;
  core::UtcTime end;
  geo::BoundingBox bounds;
};

/// The legs from each waypoint to the next. The id of a leg is the plan's id, a dot and the leg's index.
[[nodiscard]] std::vector<PlanPart> plan_legs(const repository::PlanRecord& plan);
[[nodiscard]] std::vector<PlanPart> plan_waypoints(const repository::PlanRecord& plan);

}  // namespace floeplan::codec
