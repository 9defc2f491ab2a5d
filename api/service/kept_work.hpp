#pragma once

#include <cstddef>
#include <string>

#include "engine/geo/bounding_box.hpp"
#include "engine/planning/search/route_ground.hpp"
#include "storage/repository/fields/current_grid_cache.hpp"
#include "storage/repository/fields/recently_used.hpp"

namespace floeplan::service {

/// All that the ground under a route follows from.
struct GroundKey {
  std::string conditions;  // the request but for its route
  std::string contents;    // of the store
  geo::BoundingBox area;   // of which the data are
  planning::search::RouteSite site;

  friend bool operator==(const GroundKey&, const GroundKey&) = default;
};

/// What jobs on one store keep for those after them: reading and laying out a sea takes most of the time of a small
/// job, and whoever moves a waypoint asks for nearly the same again.
/// Threads  all members may be used from several threads at once
struct KeptWork {
  repository::CurrentGridCache currents;
  repository::RecentlyUsed<GroundKey, planning::search::RouteGround> grounds;
};

}  // namespace floeplan::service
