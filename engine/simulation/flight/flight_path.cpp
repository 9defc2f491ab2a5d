#include "engine/simulation/flight/flight_path.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::simulation {
namespace {

/// Shortest leg of a hold. The vehicle spends this time at the surface at each turn.
constexpr core::Seconds shortest_leg{360.0};

/// Adds the legs that the vehicle may fly until the pilot ends the hold: the ordered list, then whole
/// repetitions of it.
void lay_hold(FlightPath& path, const GotoOrders& list, const std::vector<Vector>& places) {
  const mission::HoldTimes& planned = *list.hold->planned;
  const auto ordered = static_cast<std::size_t>(std::max(1, list.rows.legs));
  const auto most = static_cast<std::size_t>(std::ceil((planned.until - planned.from) / shortest_leg));
  const std::size_t count = (1 + (most + ordered - 1) / ordered) * ordered;
  const std::size_t next = path.stops.size() + count;
  for (std::size_t leg = 0; leg < count; ++leg) {
    const bool ends_list = list.rows.legs > 0 ? (leg + 1) % ordered == 0 : leg + 1 == count;
    path.stops.push_back({.place = places[leg % places.size()],
                          .radius_m = list.radius.value,
                          .ends_list = ends_list,
                          .hold = HoldEnd{planned.until, next}});
  }
}

}  // namespace

FlightPath flight_path(const World& world, const MissionOrders& orders, geo::LonLat start) {
  FlightPath path;
  for (std::size_t i = 0; i < orders.lists.size() && !path.loops_to; ++i) {
    const GotoOrders& list = orders.lists[i];
    std::vector<Vector> places;
    places.reserve(list.waypoints.size());
    for (const geo::LonLat place : list.waypoints) places.push_back(world.to_frame(place));
    if (list.hold && list.hold->planned && i + 1 < orders.lists.size()) {
      lay_hold(path, list, places);
      continue;
    }
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
