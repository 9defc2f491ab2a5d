#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/isochrone_request.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning {

/// The area that can be reached within one span. Polygons as in GeoJSON: outer rings counter-clockwise, holes
/// clockwise, split at the antimeridian.
struct Isochrone {
  core::Seconds span{};
  core::UtcTime time;  // arrival at the places; if backwards, departure from them
  std::vector<geo::Polygon> polygons;
  double area_m2{};
};

struct Isochrones {
  std::vector<Isochrone> areas;  // ascending by span
  SearchStatistics search;
  std::vector<ocean::DatasetRef> datasets;
  std::vector<messages::Message> messages;
};

/// The places that the vehicle can reach within each span after it leaves `request.place` at `request.time`.
/// Backwards: the places from which it reaches `request.place` in time if it leaves at most a span earlier.
/// It may leave later than that if an iceberg or a zone covers the place at first. One search serves all
/// spans: larger areas contain the smaller ones.
/// Accuracy  Outlines are interpolated between vertices of the grid. Legs follow the grid's directions, which
///           makes a route up to 1.3 % longer with 3 sectors. Where currents are as fast as the vehicle, legs
///           are closed that would be open in other directions. Areas are then some per cent too small, and
///           backwards may lack places from which a current slackens later; a warning says so. Land and
///           closed water narrower than a grid step may lie inside. Among drifting icebergs and timed zones
///           each place keeps its earliest arrival: a place that only a later arrival leads to is left out.
///           With a limit on the time without surfacing, places may be left out that need nearly all of it.
///           The battery does not limit the areas: a warning says so
/// Errors    why the place cannot be used; Reason::too_large; Reason::cancelled within 100 ms after `stop` is
///           requested
/// Throws    std::invalid_argument when `request.violations()` is not empty
[[nodiscard]] Result<Isochrones> find_isochrones(const ocean::Environment& environment,
                                                 const IsochroneRequest& request, const std::stop_token& stop,
                                                 const core::ProgressCallback& progress);

}  // namespace floeplan::planning
