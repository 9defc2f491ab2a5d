#include "engine/planning/search/surfacing/surfacing_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/planning/currents/current_envelope.hpp"
#include "engine/planning/search/bounds/favourable_grid.hpp"
#include "engine/planning/search/surfacing/surfacing_hours.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::search::surfacing_reach_test {
namespace {

const geo::LocalProjection projection{{-53.0, 69.0}};
constexpr core::Seconds at_once{0.0};

/// Columns and rows 5 km apart, from the west to the east.
cost::RouteGrid wide_grid(int nx, int ny) {
  cost::RouteGrid grid;
  grid.origin = {-2500.0 * (nx - 1), -2500.0 * (ny - 1)};
  grid.along = {5000.0, 0.0};
  grid.across = {0.0, 5000.0};
  grid.nx = nx;
  grid.ny = ny;
  grid.start = static_cast<graph::Vertex>((ny / 2) * nx);
  grid.goal = grid.start + static_cast<graph::Vertex>(nx - 1);
  return grid;
}

PlanRequest bounded_request(double bound_h) {
  PlanRequest request = support::eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{3600.0 * bound_h};
  return request;
}

/// A tide that turns through the compass and eddies.
std::shared_ptr<const ocean::CurrentGrid> random_currents(std::mt19937_64& rng, int hours) {
  const double strength_m_s = support::uniform(rng, 0.05, 0.25);
  const double phase = support::uniform(rng, 0.0, 6.28);
  const double scale = support::uniform(rng, 3.0, 12.0);
  return support::currents_from(
      [=](geo::LonLat p, double hour) {
        const double angle = 0.5 * hour + phase + scale * (p.lon_deg + 2.0 * p.lat_deg);
        return geo::VelocityEn{core::MetresPerSecond{strength_m_s * std::cos(angle)},
                               core::MetresPerSecond{strength_m_s * std::sin(angle)}};
      },
      hours);
}

/// Patches of ice that drift to the west.
std::shared_ptr<const ocean::IceField> random_ice(std::mt19937_64& rng) {
  const double phase = support::uniform(rng, 0.0, 6.28);
  const double mean = support::uniform(rng, 0.1, 0.7);
  const double drift = support::uniform(rng, 0.0, 0.1);
  return support::ice_from(
      [=](geo::LonLat p, double hour) {
        return std::clamp(
            mean + 0.6 * std::sin(4.0 * p.lon_deg + phase + drift * hour) + 0.2 * std::sin(9.0 * p.lat_deg),
            0.0, 1.0);
      },
      {0.0, 12.0, 24.0, 48.0, 96.0}, 1.0);
}

TEST(CurrentEnvelope, EnclosesTheCurrentsNearbyAtAllTimes) {
  int looks = 0;
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const ocean::Environment environment{.currents = random_currents(rng, 48)};
    const PlanRequest request = support::eastward_request();
    const plane::PlaneBox area{{-60'000.0, -60'000.0}, {60'000.0, 60'000.0}};
    const cost::Sea sea{environment, request, projection, area, core::Metres{1000.0}};
    const double reach_m = support::uniform(rng, 500.0, 12'000.0);
    const currents::CurrentEnvelope envelope{*sea.domain().currents(), core::Metres{reach_m}};
    for (int i = 0; i < 200; ++i) {
      const geo::PlanePoint point{support::uniform(rng, -25'000.0, 25'000.0),
                                  support::uniform(rng, -25'000.0, 25'000.0)};
      const double angle = support::uniform(rng, 0.0, 6.28);
      const double away_m = support::uniform(rng, 0.0, reach_m);
      const auto current = (*sea.domain().currents())(
          {point.x_m + away_m * std::cos(angle), point.y_m + away_m * std::sin(angle)},
          core::Seconds{support::uniform(rng, 0.0, 47.0 * 3600.0)});
      if (!current) continue;
      ++looks;
      const geo::PlanePoint direction{std::cos(2.0 * angle), std::sin(2.0 * angle)};
      const double along_m_s = current->x_m_s * direction.x_m + current->y_m_s * direction.y_m;
      EXPECT_LE(along_m_s, envelope.about(point).most_along(direction).value + 1e-6);
    }
  });
  EXPECT_GT(looks, 2000);
}

TEST(CurrentEnvelope, TellsAStrongStreamFromTheStillWaterBesideIt) {
  const ocean::Environment environment{.currents = support::currents_from(
                                           [](geo::LonLat p, double) {
                                             return geo::VelocityEn{
                                                 core::MetresPerSecond{p.lat_deg > 69.2 ? 0.5 : 0.0},
                                                 core::MetresPerSecond{0.0}};
                                           },
                                           2)};
  const plane::PlaneBox area{{-60'000.0, -60'000.0}, {60'000.0, 60'000.0}};
  const cost::Sea sea{environment, support::eastward_request(), projection, area, core::Metres{1000.0}};
  const currents::CurrentEnvelope envelope{*sea.domain().currents(), core::Metres{2000.0}};
  EXPECT_NEAR(envelope.about({0.0, 0.0}).most_along({1.0, 0.0}).value, 0.0, 0.01);
  EXPECT_NEAR(envelope.about({0.0, 50'000.0}).most_along({1.0, 0.0}).value, 0.5, 0.01);
  EXPECT_LT(envelope.about({0.0, 50'000.0}).most_along({-1.0, 0.0}).value, -0.45);
}

TEST(FavourableGrid, NeverTakesLongerThanAVehicleDoes) {
  int legs = 0;
  double nearest = 0.0;
  support::for_each_seed(20, [&](std::mt19937_64& rng) {
    const ocean::Environment environment{.currents = random_currents(rng, 48)};
    const PlanRequest request = support::eastward_request();
    const cost::RouteGrid grid = wide_grid(9, 7);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(4000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
    const FavourableGrid favourable{sea, open};
    std::vector<std::vector<double>> least_s(open.graph.size(), std::vector<double>(open.graph.size(), 0.0));
    for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
      favourable.for_each_edge_from(v, [&](const graph::Edge& edge, double edge_s) {
        least_s[edge.tail][edge.head] = edge_s;
        for (int i = 0; i < 4; ++i) {
          const core::Seconds depart{3600.0 * support::uniform(rng, 0.0, 30.0)};
          const auto time = sea.leg_time(grid.point(edge.tail), grid.point(edge.head), depart);
          if (!time) continue;
          ++legs;
          EXPECT_LE(edge_s, time->count());
          nearest = std::max(nearest, edge_s / time->count());
        }
      });
    }
    for (graph::Vertex v = 0; v < open.graph.size(); ++v) {
      favourable.for_each_edge_to(v, [&](const graph::Edge& edge, double edge_s) {
        EXPECT_EQ(edge.head, v);
        EXPECT_EQ(edge_s, least_s[edge.tail][edge.head]);
      });
    }
  });
  EXPECT_GT(legs, 20'000);
  EXPECT_GT(nearest, 0.9) << "with the current astern it says nearly what it takes";
}

TEST(SurfacingReach, LeavesEveryPlaceWhereAVehicleThatKeepsTheBoundComes) {
  int visits = 0;
  int at_goal = 0;
  int left_out = 0;
  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    const ocean::Environment environment{.currents = random_currents(rng, 120), .ice = random_ice(rng)};
    const PlanRequest request = bounded_request(support::uniform(rng, 2.0, 16.0));
    cost::RouteGrid grid = wide_grid(13, 9);
    grid.goal = grid.start + static_cast<graph::Vertex>(support::uniform(rng, 2.0, 8.0));
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(4000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
    const core::Seconds depart{3600.0 * support::uniform(rng, 0.0, 20.0)};
    const SurfacingReach reach{sea, open, depart, at_once, {}};
    const FavourableGrid favourable{sea, open};
    const HourlyReach hourly = reach_hour_by_hour(sea, favourable, depart, at_once, {});
    left_out += static_cast<int>(open.vertices - reach.grid().vertices);

    for (int walk = 0; walk < 100; ++walk) {
      std::vector<graph::Vertex> way{grid.start};
      core::Seconds now = depart;
      core::Seconds since = at_once;
      bool reached_goal = false;
      for (int step = 0; step < 40 && !reached_goal; ++step) {
        std::vector<graph::Vertex> heads;
        const bool is_eastbound = support::uniform(rng, 0.0, 1.0) < 0.85;
        open.graph.for_each_edge(way.back(), [&](const graph::Edge& edge) {
          if (!is_eastbound || open.graph.offsets()[edge.step].dx > 0) heads.push_back(edge.head);
        });
        if (heads.empty()) continue;
        const graph::Vertex head = heads[static_cast<std::size_t>(
            support::uniform(rng, 0.0, static_cast<double>(heads.size()) - 1e-9))];
        const auto leg = sea.leg(grid.point(way.back()), grid.point(head), now, since);
        if (!leg) continue;
        way.push_back(head);
        now += leg->time;
        since = leg->since_surfacing;
        reached_goal = head == grid.goal;
        ++visits;
        if (!hourly.reaches_goal) {
          ASSERT_TRUE(hourly.reached[head]) << "step " << step << " of walk " << walk;
        }
      }
      if (!reached_goal) continue;
      ++at_goal;
      ASSERT_TRUE(reach.has_hope());
      for (const graph::Vertex v : way) ASSERT_TRUE(reach.grid().graph.is_open(v));
    }
  });
  EXPECT_GT(visits, 5000);
  EXPECT_GT(at_goal, 10);
  EXPECT_GT(left_out, 20);
}

TEST(SurfacingReach, CountsOnNoOpeningThatHasClosedBeforeTheVehicleIsThere) {
  // A belt of ice with a lane in its middle, in one case always, in the other for the first three hours only.
  for (const double closes_h : {240.0, 3.0}) {
    const ocean::Environment environment{.ice = support::ice_from(
                                             [&](geo::LonLat p, double hour) {
                                               if (std::abs(p.lon_deg + 53.0) > 0.9) return 0.0;
                                               const bool is_lane = std::abs(p.lon_deg + 53.0) < 0.15;
                                               return is_lane && hour < closes_h ? 0.0 : 0.9;
                                             },
                                             {0.0, 1.0, 2.0, 3.0, 4.0, 120.0}, 1.0)};
    const PlanRequest request = bounded_request(26.0);
    const cost::RouteGrid grid = wide_grid(31, 9);
    const cost::Sea sea{environment, request, projection, grid.bounds().grown(4000.0), core::Metres{1000.0}};
    const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
    const SurfacingReach reach{sea, open, core::Seconds{3600.0}, at_once, {}};
    EXPECT_EQ(reach.has_hope(), closes_h > 100.0);
  }
}

TEST(SurfacingReach, HasHopeWhereNothingIsKnownOfIce) {
  const ocean::Environment environment;
  const cost::RouteGrid grid = wide_grid(9, 7);
  const cost::Sea sea{environment, bounded_request(1.0), projection, grid.bounds().grown(4000.0),
                      core::Metres{1000.0}};
  const OpenGrid open = open_grid(sea.domain(), grid, 2, {});
  const SurfacingReach reach{sea, open, at_once, at_once, {}};
  EXPECT_TRUE(reach.has_hope());
  EXPECT_EQ(reach.grid().vertices, open.vertices);
}

}  // namespace
}  // namespace floeplan::planning::search::surfacing_reach_test
