#include "engine/simulation/flight/flight_path.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::simulation {

FlightPath flight_path(const World& world, const MissionOrders& orders, geo::LonLat start) {
  FlightPath path;
  for (std::size_t i = 0; i < orders.lists.size() && !path.loops_to; ++i) {
    const GotoOrders& list = orders.lists[i];
    std::vector<Vector> places;
    places.reserve(list.waypoints.size());
    for (const geo::LonLat place : list.waypoints) places.push_back(world.to_frame(place));
    const Vector from = path.stops.empty() ? world.to_frame(start) : path.stops.back().place;
    const auto closest = std::ranges::min_element(places, {}, [&](Vector place) {
      return std::hypot(place.east - from.east, place.north - from.north);
    });

    const mission::FlownRows flown =
        mission::flown_rows(list.rows, places.size(), static_cast<std::size_t>(closest - places.begin()));
    if (flown.goes_round) path.loops_to = path.stops.size();
    for (const std::size_t row : flown.rows)
      path.stops.push_back({.place = places[row], .radius_m = list.radius.value});
    path.stops.back().ends_list = !path.loops_to && !list.next_on_board && i + 1 < orders.lists.size();
  }
  return path;
}

}  // namespace floeplan::simulation
