#pragma once

#include <cstddef>
#include <string>

#include "engine/geo/bounding_box.hpp"
#include "engine/planning/search/route_ground.hpp"
#include "storage/repository/fields/current_grid_cache.hpp"
#include "storage/repository/fields/recently_used.hpp"

namespace floeplan::service {

/// Everything that determines a RouteGround.
struct GroundKey {
  std::string conditions;  // the request without its route
  std::string contents;    // digest of the store's content
  geo::BoundingBox area;   // area of the data
  planning::search::RouteSite site;

  friend bool operator==(const GroundKey&, const GroundKey&) = default;
};

/// Caches that jobs on one store share. Reading the data and preparing grids takes most of the time of a
/// small job, and a user who moves a waypoint sends nearly the same request again.
/// Threads  all members may be used from several threads at once
struct KeptWork {
  repository::CurrentGridCache currents;
  repository::RecentlyUsed<GroundKey, planning::search::RouteGround> grounds;
};

}  // namespace floeplan::service
