#include "engine/planning/search/energy/cost_voyage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "engine/planning/search/energy/cost_search.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::cost_voyage_test {
namespace {

const plane::PlaneBox area{{-12'000.0, -12'000.0}, {12'000.0, 12'000.0}};

/// 3 x 3 vertices, 4 km apart.
const cost::RouteGrid small_grid{.origin = {-4'000.0, -4'000.0},
                                 .along = {4'000.0, 0.0},
                                 .across = {0.0, 4'000.0},
                                 .nx = 3,
                                 .ny = 3,
                                 .start = 0,
                                 .goal = 8};

PlanRequest hybrid_request(const Objective& objective) {
  PlanRequest request = support::eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  request.energy.objective = objective;
  return request;
}

/// Calls a function for every simple route and every choice of drives.
struct BruteForce {
  const cost::Sea& sea;
  const OpenGrid& open;
  const Objective& objective;
  double best{std::numeric_limits<double>::infinity()};
  std::set<graph::Vertex> on_way{};

  void go_on(graph::Vertex v, double now_s, double cost) {
    if (cost >= best) return;
    if (v == open.grid.goal) {
      best = cost;
      return;
    }
    on_way.insert(v);
    open.graph.for_each_edge(v, [&](const graph::Edge& edge) {
      if (on_way.contains(edge.head)) return;
      for (const vehicle::Drive drive : sea.drives()) {
        const geo::PlanePoint a = open.grid.point(v);
        const geo::PlanePoint b = open.grid.point(edge.head);
        const auto driven = sea.metered_leg(a, b, core::Seconds{now_s}, core::Seconds{0.0},
                                            core::Seconds{INFINITY}, drive, cost::Dives::over_map);
        if (!driven) continue;
        const core::Seconds time = driven->leg.time;
        go_on(edge.head, now_s + time.count(), cost + objective.cost(time, driven->energy.total()));
      }
    });
    on_way.erase(v);
  }
};

double random_depth_m(std::uint64_t seed, geo::LonLat place) {
  return 140.0 + 110.0 * std::sin(static_cast<double>(seed) + 15.0 * place.lon_deg + 25.0 * place.lat_deg);
}

/// Random depths below a tide that turns twice a day.
ocean::Environment tidal_sea(std::mt19937_64& rng, const geo::VelocityEn& strongest, int hours) {
  const auto seed = static_cast<std::uint64_t>(support::uniform_int(rng, 0, 1000));
  ocean::Environment environment;
  environment.bathymetry =
      support::bathymetry_from([=](geo::LonLat place) { return random_depth_m(seed, place); });
  environment.currents = support::currents_from(
      [=](geo::LonLat place, double hour) {
        return geo::VelocityEn{{strongest.east.value * std::sin(9.0 * place.lon_deg + 0.5 * hour)},
                               {strongest.north.value * std::cos(0.5 * hour + static_cast<double>(seed))}};
      },
      hours);
  return environment;
}

void expect_least_cost(const ocean::Environment& environment, const Objective& objective, double tolerance) {
  const PlanRequest request = hybrid_request(objective);
  const geo::LocalProjection projection{{-53.0, 69.0}};
  const cost::Sea sea{environment, request, projection, area, core::Metres{1000.0}};
  const OpenGrid open = open_grid(sea.domain(), small_grid, 1, {});
  CostVoyage voyage{sea, open, objective};
  BruteForce brute_force{.sea = sea, .open = open, .objective = objective};

  const auto search = graph::find_best_labels(open.graph, open.grid.start, open.grid.goal, 0.0,
                                              CostVoyage::State{}, voyage, 1'000'000, {});
  brute_force.go_on(open.grid.start, 0.0, 0.0);

  ASSERT_TRUE(search.goal.has_value());
  EXPECT_NEAR(search.labels[*search.goal].state.cost, brute_force.best, tolerance * brute_force.best);
}

const Objective objectives[] = {energy_objective, {1.0, 0.1}, {1.0, 0.4}};

TEST(CostVoyage, IsExactInSteadyWaters) {
  support::for_each_seed(5, [](std::mt19937_64& rng) {
    const auto seed = static_cast<std::uint64_t>(support::uniform_int(rng, 0, 1000));
    ocean::Environment environment;
    environment.bathymetry =
        support::bathymetry_from([&](geo::LonLat place) { return random_depth_m(seed, place); });
    environment.currents = support::currents_from(
        [&](geo::LonLat place, double) {
          return geo::VelocityEn{{0.2 * std::sin(9.0 * place.lon_deg + static_cast<double>(seed))},
                                 {0.1 * std::cos(30.0 * place.lat_deg)}};
        },
        0);
    environment.steady_currents = true;
    for (const Objective& objective : objectives) expect_least_cost(environment, objective, 1e-9);
  });
}

TEST(CostVoyage, IsNearlyExactInATide) {
  support::for_each_seed(4, [](std::mt19937_64& rng) {
    const ocean::Environment environment = tidal_sea(rng, {{0.2}, {0.2}}, 96);
    for (const Objective& objective : objectives) expect_least_cost(environment, objective, 0.01);
  });
}

TEST(CostVoyage, KeepsTheDearerDriveWhereTheCheaperOneIsBelowIceForTooLong) {
  // 11.3 km in still water: 32,000 s on the buoyancy drive, 22,000 s on the thruster, 27,000 s on one after the other.
  ocean::Environment environment;
  environment.ice = support::ice_from([](geo::LonLat, double) { return 0.9; }, {0.0}, 1.0);
  PlanRequest request = hybrid_request(energy_objective);
  request.under_ice.max_time_without_surfacing = core::Seconds{25'000.0};
  const cost::Sea sea{environment, request, geo::LocalProjection{{-53.0, 69.0}}, area, core::Metres{1000.0}};
  const OpenGrid open = open_grid(sea.domain(), small_grid, 1, {});
  CostVoyage voyage{sea, open, energy_objective};
  const auto at_half_way = [&](double arrival_s, double cost) {
    return graph::Label<CostVoyage::State>{
        .vertex = 4, .arrival_s = arrival_s, .state = {.cost = cost, .surfaced_s = 0.0}};
  };
  const auto on_buoyancy = at_half_way(16'000.0, 1.0);
  const auto on_thruster = at_half_way(11'000.0, 2.0);

  EXPECT_FALSE(voyage.dominates(4, on_buoyancy, on_thruster));
  EXPECT_FALSE(voyage.dominates(4, on_thruster, on_buoyancy));
  EXPECT_TRUE(voyage.dominates(4, at_half_way(11'000.0, 0.9), on_buoyancy));
}

/// The cost found by the search with its limits, relative to that of a search without limits.
double share_of_plain_cost(const ocean::Environment& environment, const Objective& objective) {
  const PlanRequest request = hybrid_request(objective);
  const cost::RouteGrid grid = cost::lay_grid({-20'000.0, 0.0}, {20'000.0, 3000.0},
                                              {core::Metres{4000.0}, core::Metres{4000.0}}, {0.5, 0.25});
  const cost::Sea sea{environment, request, geo::LocalProjection{{-53.0, 69.0}}, grid.bounds().grown(2500.0),
                      core::Metres{800.0}};
  std::vector<OpenGrid> grids;
  grids.push_back(open_grid(sea.domain(), grid, request.sectors, {}));
  CostVoyage voyage{sea, grids[0], objective};
  const auto plain = graph::find_best_labels(grids[0].graph, grid.start, grid.goal, 0.0, CostVoyage::State{},
                                             voyage, 1'000'000, {});
  const auto found = search_least_cost(sea, grids, request, core::Seconds{0.0}, {}, [](double) {});
  EXPECT_EQ(plain.goal.has_value(), found.has_value());
  if (!plain.goal || !found) return 1.0;
  EXPECT_LE(found->statistics.expansions, plain.counters.expansions);
  const auto times =
      cost::drive_along(sea, found->route, core::Seconds{0.0}, core::Seconds{0.0}, cost::Dives::over_map);
  if (!times) return INFINITY;
  return times->cost(objective) / plain.labels[*plain.goal].state.cost;
}

TEST(SearchLeastCost, FindsWithItsLimitsWhatASearchWithoutThemFinds) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    ocean::Environment environment = tidal_sea(rng, {{0.15}, {0.1}}, 240);
    for (const Objective& objective : objectives) {
      EXPECT_LE(share_of_plain_cost(environment, objective), 1.002);
    }
    environment.steady_currents = true;
    EXPECT_NEAR(share_of_plain_cost(environment, energy_objective), 1.0, 1e-9);
  });
}

/// A route of 40 km over random depths in a tide, on a grid with more vertices than an unsteered search is meant for.
struct LargeGrid {
  ocean::Environment environment;
  PlanRequest request;
  cost::RouteGrid grid;
  cost::Sea sea;
  std::vector<OpenGrid> grids;

  LargeGrid(std::mt19937_64& rng, const PlanRequest& asked, core::Metres spacing)
      : environment{tidal_sea(rng, {{0.15}, {0.1}}, 240)},
        request{asked},
        grid{cost::lay_grid({-20'000.0, 0.0}, {20'000.0, 3000.0}, {spacing, spacing}, {0.5, 0.25})},
        sea{environment, request, geo::LocalProjection{{-53.0, 69.0}}, grid.bounds().grown(2500.0),
            core::Metres{800.0}} {
    grids.push_back(open_grid(sea.domain(), grid, 2, {}));
  }
  LargeGrid(const LargeGrid&) = delete;
  LargeGrid& operator=(const LargeGrid&) = delete;

  [[nodiscard]] auto plain_search(graph::Vertex from, double now_s) const {
    CostVoyage voyage{sea, grids[0], request.objective()};
    return graph::find_best_labels(grids[0].graph, from, grid.goal, now_s,
                                   CostVoyage::State{.surfaced_s = now_s}, voyage, 1'000'000, {});
  }
  [[nodiscard]] double cost_of(const CostWay& way, core::Seconds depart) const {
    return cost::drive_along(sea, way.route, depart, core::Seconds{0.0}, cost::Dives::over_map)
        ->cost(request.objective());
  }
};

PlanRequest saving_energy() {
  PlanRequest request = support::eastward_request();
  request.energy.objective = energy_objective;
  return request;
}

TEST(SearchLeastCost, IsSteeredOverLargeGridsToAboutTheLeastCost) {
  std::mt19937_64 rng{11};
  const LargeGrid large{rng, saving_energy(), core::Metres{800.0}};
  const auto plain = large.plain_search(large.grid.start, 0.0);
  ASSERT_TRUE(plain.goal && !plain.full);

  const auto found =
      search_least_cost(large.sea, large.grids, large.request, core::Seconds{0.0}, {}, [](double) {});

  ASSERT_TRUE(found.has_value());
  const double least = plain.labels[*plain.goal].state.cost;
  const double cost = large.cost_of(*found, core::Seconds{0.0});
  EXPECT_GE(cost, (1.0 - 2e-3) * least) << "but for the spans of time that the plain search tells apart";
  EXPECT_LE(cost, 1.005 * least);
  EXPECT_LT(10 * found->statistics.expansions, plain.counters.expansions);
}

/// A route of about 40 km on a grid of 2 km. The vehicle makes up to 0.25 m/s with a current, 0.51 m/s by thruster.
struct LateScene {
  ocean::Environment environment;
  PlanRequest request{hybrid_request(energy_objective)};
  cost::RouteGrid grid{cost::lay_grid({-20'000.0, 0.0}, {20'000.0, 0.0},
                                      {core::Metres{2000.0}, core::Metres{2000.0}}, {0.5, 0.25})};
  geo::LocalProjection projection{{-53.0, 69.0}};

  explicit LateScene(int hours_of_data) {
    std::mt19937_64 rng{13};
    environment = tidal_sea(rng, {{0.1}, {0.1}}, hours_of_data);
    request.holds.longest = core::Seconds{0.0};  // a search for the least cost never holds
  }
  void close_goal(double from_h, double until_h) {
    const geo::LonLat goal = projection.to_lon_lat({20'000.0, 0.0});
    const auto corner = [&](double east, double north) {
      return geo::LonLat{goal.lon_deg + 0.07 * east, goal.lat_deg + 0.027 * north};
    };
    const auto hour = [&](double h) { return request.depart + core::Seconds{3600.0 * h}; };
    request.zones = {
        {.name = "trawlers",
         .kind = ocean::ZoneKind::no_go,
         .area = {.outer = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, .holes = {}},
         .from = hour(from_h),
         .until = hour(until_h)}};
  }
  struct Outcome {
    Result<CostWay> way;
    int reports{};  // of the searches for the least cost and for the earliest route
  };
  [[nodiscard]] Outcome search() const {
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(2500.0), core::Metres{800.0}};
    std::vector<OpenGrid> grids;
    grids.push_back(open_grid(sea.domain(), grid, request.sectors, {}));
    int reports = 0;
    auto way = search_least_cost(sea, grids, request, core::Seconds{0.0}, {}, [&](double) { ++reports; });
    return {std::move(way), reports};
  }
};

TEST(SearchLeastCost, LooksForNoWayToAGoalThatOpensTooLateForAnyDrive) {
  LateScene scene{144};
  scene.close_goal(0.0, 110.0);

  const auto [way, reports] = scene.search();

  ASSERT_FALSE(way);
  EXPECT_EQ(way.error().reason, Reason::goal_in_zone);
  ASSERT_TRUE(way.error().postponed);
  EXPECT_EQ(reports, 0) << "one search for the fastest way tells it all";
}

TEST(SearchLeastCost, LooksForAWayToAGoalThatTheThrusterReachesBeforeItCloses) {
  LateScene scene{144};
  scene.close_goal(26.0, 110.0);

  const auto [way, reports] = scene.search();

  ASSERT_TRUE(way) << way.error().explanation();
  EXPECT_TRUE(std::ranges::count(way->route.drives, vehicle::Drive::thruster) > 0);
  EXPECT_GT(reports, 0);
}

TEST(SearchLeastCost, LooksForNoWayThatEndsAfterTheData) {
  const LateScene scene{12};

  const auto [way, reports] = scene.search();

  ASSERT_FALSE(way);
  EXPECT_EQ(way.error().binding, Constraint::data_period);
  EXPECT_EQ(reports, 0);
}

TEST(CostGuide, ServesOneDepartureAfterTheOther) {
  std::mt19937_64 rng{12};
  const LargeGrid large{rng, hybrid_request({1.0, 0.2}), core::Metres{800.0}};
  std::vector<CostGuide> guides;
  guides.emplace_back(large.sea, large.grids[0], core::Seconds{12.0 * 3600.0});

  for (const double hour : {0.0, 5.0, 12.0}) {
    const core::Seconds depart{3600.0 * hour};
    const auto search = [&](std::vector<CostGuide>* kept) {
      return search_least_cost(large.sea, large.grids, large.request, depart, {}, [](double) {}, kept);
    };
    const auto guided = search(&guides);
    const auto alone = search(nullptr);
    ASSERT_TRUE(guided && alone);
    const double cost = large.cost_of(*alone, depart);
    EXPECT_NEAR(large.cost_of(*guided, depart), cost, 5e-3 * cost);
  }
}

TEST(CostOutlook, IsAboutWhatTheRestOfTheWayCosts) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    const LargeGrid large{rng, saving_energy(), core::Metres{1000.0}};
    const cost::RouteGrid& grid = large.grid;
    CostGuide guide{large.sea, large.grids[0]};
    const CostOutlook& outlook =
        guide.outlook(energy_objective, core::Seconds{0.0}, core::Seconds{100.0 * 3600.0}, {});

    for (int i = 0; i < 5; ++i) {
      const auto v = static_cast<graph::Vertex>(
          support::uniform_int(rng, 0, static_cast<int>(large.grids[0].graph.size()) - 1));
      if (geo::distance_m(grid.point(v), grid.point(grid.goal)) < 10'000.0) continue;
      const double now_s = large.sea.least_time(grid.point(grid.start), grid.point(v)).count() +
                           support::uniform(rng, 0.0, 5.0 * 3600.0);
      const auto exact = large.plain_search(v, now_s);
      ASSERT_TRUE(exact.goal.has_value());
      const double cost = exact.labels[*exact.goal].state.cost;
      EXPECT_NEAR(outlook.rest(v, now_s), cost, 0.05 * cost);
    }
  });
}

}  // namespace
}  // namespace floeplan::planning::search::cost_voyage_test
