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

/// The places within one span. Polygons as GeoJSON wants them: outer rings counter-clockwise, holes clockwise, split
/// at the antimeridian.
struct Isochrone {
  core::Seconds span{};
  core::UtcTime time;  // when the vehicle would be there; when it would have to be there
  std::vector<geo::Polygon> polygons;
  double area_m2{};
};

struct Isochrones {
  std::vector<Isochrone> areas;  // by span, ascending
  SearchStatistics search;
  std::vector<ocean::DatasetRef> datasets;
  std::vector<messages::Message> messages;
};

/// The places that the vehicle can have reached after each span when it leaves the place at the request's time;
/// backwards, the places from which it is there in time when it leaves no more than a span earlier, which may be later
/// than at that moment where an iceberg or a zone covers the place then. One search for all spans: the areas are
/// nested, the larger span around the smaller one.
/// Accuracy  borders are interpolated between vertices of the grid; legs keep to the grid's directions, which makes a
///           way up to 1.3 % longer with 3 sectors. Where currents are as fast as the vehicle legs are closed that
///           would be open in other directions: areas are some per cent too small there, and backwards lack places
///           from which a current opens later; a warning says so. Land and closed water thinner than a step of the
///           grid may lie inside. Among icebergs that drift and zones in force for a while the earliest arrival
///           everywhere is taken: a place that only a later one leads to is left out. With a bound on the time
///           without surfacing, places that only ways lead to that need nearly all of it may be left out. A battery
///           that does not last cuts nothing off: a warning says so
/// Errors    why the place cannot be used; Reason::too_large; Reason::cancelled within 100 ms of a request of `stop`
/// Throws    std::invalid_argument when `request.violations()` is not empty
[[nodiscard]] Result<Isochrones> find_isochrones(const ocean::Environment& environment,
                                                 const IsochroneRequest& request, const std::stop_token& stop,
                                                 const core::ProgressCallback& progress);

}  // namespace floeplan::planning
