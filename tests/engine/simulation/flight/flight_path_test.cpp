#include "engine/simulation/flight/flight_path.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/simulation/flight/equipped_vehicle.hpp"
#include "tests/engine/simulation/flown.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::flight_path_test {
namespace {

using testing::SizeIs;

/// A list with random orders about its rows.
GotoOrders random_list(std::mt19937_64& rng, const World& world) {
  const int rows = support::uniform_int(rng, 1, 6);
  GotoOrders list;
  for (int i = 0; i < rows; ++i)
    list.waypoints.push_back(
        world.to_lon_lat({support::uniform(rng, -5e3, 5e3), support::uniform(rng, -5e3, 5e3), 0.0}));
  const int legs = support::uniform_int(rng, -2, 14);
  list.rows = {.legs = legs == 0 ? -2 : legs, .initial = support::uniform_int(rng, -2, rows - 1)};
  return list;
}

/// Law: the simulated pilot and the avoidance system give the same waypoints the same numbers. The numbers count the rows
/// that the lists fly, list by list, up to a list that repeats without end.
TEST(FlightPath, IsWhatTheSystemOnBoardIsGiven) {
  const World world = support::uniform_water(0.0, 0.0);
  support::for_each_seed(200, [&](std::mt19937_64& rng) {
    MissionOrders orders;
    const int lists = support::uniform_int(rng, 1, 3);
    for (int i = 0; i < lists; ++i) orders.lists.push_back(random_list(rng, world));

    const FlightPath path = flight_path(world, orders, support::flight_origin);
    const SystemOnBoard system =
        system_for(world, orders, support::flight_origin, support::flight_start, core::Seconds{3600.0});

    std::size_t legs = 0;
    Vector here = world.to_frame(support::flight_origin);
    for (const GotoOrders& list : orders.lists) {
      const std::size_t rows = list.waypoints.size();
      std::size_t row = list.rows.initial >= 0 ? static_cast<std::size_t>(list.rows.initial) : 0;
      if (list.rows.initial == -2) {
        double least_m = INFINITY;
        for (std::size_t i = 0; i < rows; ++i) {
          const Vector place = world.to_frame(list.waypoints[i]);
          const double off_m = std::hypot(place.east - here.east, place.north - here.north);
          if (off_m < least_m) row = i;
          least_m = std::min(least_m, off_m);
        }
      }
      const std::size_t of_list = list.rows.legs == -1   ? rows
                                  : list.rows.legs == -2 ? rows - row
                                                         : static_cast<std::size_t>(list.rows.legs);
      for (std::size_t leg = 0; leg < of_list; ++leg, row = (row + 1) % rows, ++legs) {
        ASSERT_LT(legs, path.stops.size());
        here = world.to_frame(list.waypoints[row]);
        EXPECT_EQ(path.stops[legs].place.east, here.east);
        EXPECT_EQ(path.stops[legs].place.north, here.north);
      }
      if (list.rows.legs == -1) break;
    }
    EXPECT_THAT(path.stops, SizeIs(legs));
    ASSERT_THAT(system.waypoints, SizeIs(legs));
    for (std::size_t i = 0; i < legs; ++i) {
      EXPECT_EQ(system.waypoints[i].x_m, path.stops[i].place.east);
      EXPECT_EQ(system.waypoints[i].y_m, path.stops[i].place.north);
    }
  });
}

}  // namespace
}  // namespace floeplan::simulation::flight_path_test
