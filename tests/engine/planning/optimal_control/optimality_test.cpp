#include "engine/planning/optimal_control/optimality.hpp"

#include <gtest/gtest.h>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/support/river_crossing.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::optimal_control::optimality_test {
namespace {

using support::currents_from;
using support::eastward_request;

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double phase = 2.0 * 3.14159265358979 * hour / 12.42;
  return {{0.15 * std::cos(phase)}, {0.2 * std::sin(phase + place.lon_deg)}};
}

/// The paper's river on the equator, where degrees are proportional to metres. Its nodes lie 560 m apart.
struct EquatorialRiver {
  geo::LonLat from{0.0, 0.0};
  geo::LonLat to{0.3, 0.0};
  currents::RiverCurrent river{.width_m = geo::geodesic_between(from, to).length.value, .peak_m_s = 0.25};

  [[nodiscard]] ocean::Environment environment() const {
    const ocean::HorizontalGrid grid{geo::GeographicFrame{}, support::steps(-0.1, 0.005, 101),
                                     support::steps(-0.3, 0.05, 13)};
    ocean::CurrentGrid::Samples samples{.grid = grid,
                                        .depths_m = std::nullopt,
                                        .times_s = support::steps(support::sea_start_s, 3600.0, 2),
                                        .u = {},
                                        .v = {}};
    for (int time = 0; time < 2; ++time) {
      for (std::size_t iy = 0; iy < grid.y().size(); ++iy) {
        for (std::size_t ix = 0; ix < grid.x().size(); ++ix) {
          const double share = grid.place(ix, iy).lon_deg / to.lon_deg;
          samples.u.push_back(0.0F);
          samples.v.push_back(static_cast<float>(4.0 * share * (1.0 - share) * river.peak_m_s));
        }
      }
    }
    ocean::Environment environment;
    environment.currents = std::make_shared<const ocean::CurrentGrid>(std::move(samples));
    environment.steady_currents = true;
    return environment;
  }

  [[nodiscard]] PlanRequest request(Method method) const {
    PlanRequest request = eastward_request();
    request.from = from;
    request.to = to;
    request.method = method;
    return request;
  }

  [[nodiscard]] double gap_of(core::Seconds travel_time, core::MetresPerSecond speed) const {
    return travel_time / support::river_crossing_by_optimal_control(river, speed) - 1.0;
  }
};

TEST(Optimality, IsThatOfTheClosedSolutionOverTheRiver) {
  const EquatorialRiver world;
  for (const Method method : {Method::direct, Method::astar}) {
    const PlanRequest request = world.request(method);

    const auto plan = plan_route(world.environment(), request, {}, {});

    ASSERT_TRUE(plan.has_value());
    ASSERT_TRUE(plan->optimality_gap.has_value()) << plan->optimality_gap_reason;
    const double exact = world.gap_of(plan->travel_time(), request.vehicle.speed_through_water);
    EXPECT_NEAR(*plan->optimality_gap, exact, 0.001);
    EXPECT_TRUE(plan->optimality_gap_reason.empty());
  }
}

TEST(Optimality, IsNothingInStillWater) {
  const auto plan = plan_route({}, eastward_request(), {}, {});

  ASSERT_TRUE(plan.has_value());
  ASSERT_TRUE(plan->optimality_gap.has_value()) << plan->optimality_gap_reason;
  EXPECT_NEAR(*plan->optimality_gap, 0.0, 1e-6);
}

TEST(Optimality, IsNeverNegativeAndGrowsWithTheDetour) {
  const ocean::Environment environment{.currents = currents_from(tide, 96)};
  PlanRequest request = eastward_request();
  const auto best = plan_route(environment, request, {}, {});
  request.method = Method::direct;
  const auto direct = plan_route(environment, request, {}, {});

  ASSERT_TRUE(best && direct);
  ASSERT_TRUE(best->optimality_gap.has_value()) << best->optimality_gap_reason;
  ASSERT_TRUE(direct->optimality_gap.has_value()) << direct->optimality_gap_reason;
  EXPECT_GE(*best->optimality_gap, 0.0);
  EXPECT_LT(*best->optimality_gap, 0.05);
  const double slower = direct->travel_time() / best->travel_time();
  EXPECT_NEAR((1.0 + *direct->optimality_gap) / (1.0 + *best->optimality_gap), slower, 0.001);
}

TEST(Optimality, CountsFromStopToStopForAVoyage) {
  PlanRequest request = eastward_request();
  request.via = {{-53.0, 69.1}};

  const auto plan = plan_route({}, request, {}, {});

  ASSERT_TRUE(plan.has_value());
  ASSERT_TRUE(plan->optimality_gap.has_value()) << plan->optimality_gap_reason;
  EXPECT_NEAR(*plan->optimality_gap, 0.0, 1e-6) << "the place is to be visited by the best way too";
}

TEST(Optimality, OfAGivenRouteCountsFromEndToEnd) {
  const std::vector<geo::LonLat> route{{-53.5, 69.0}, {-53.0, 69.1}, {-52.5, 69.0}};

  const auto plan = evaluate_route({}, route, eastward_request());

  ASSERT_TRUE(plan.has_value());
  const double straight_m = geo::geodesic_between(route.front(), route.back()).length.value;
  ASSERT_TRUE(plan->optimality_gap.has_value()) << plan->optimality_gap_reason;
  EXPECT_NEAR(*plan->optimality_gap, plan->distance.value / straight_m - 1.0, 1e-4);
}

TEST(Optimality, IsNotGivenWhereAnIcebergShapesTheRoute) {
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 400.0)};

  const auto plan = plan_route(environment, eastward_request(), {}, {});

  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->optimality_gap.has_value());
  EXPECT_NE(plan->optimality_gap_reason.find("iceberg"), std::string::npos) << plan->optimality_gap_reason;
}

TEST(Optimality, IsNotGivenWhereAShoalShapesTheRoute) {
  const ocean::Environment environment{.bathymetry = support::bathymetry_from([](geo::LonLat place) {
                                         return std::abs(place.lon_deg + 53.0) < 0.15 && place.lat_deg < 69.1
                                                    ? 5.0
                                                    : 300.0;
                                       })};

  const auto plan = plan_route(environment, eastward_request(), {}, {});

  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->optimality_gap.has_value());
  EXPECT_NE(plan->optimality_gap_reason.find("too shallow"), std::string::npos);
}

TEST(Optimality, IsNotGivenWhereTheTimeUnderIceShapesTheRoute) {
  const ocean::Environment environment{.ice = support::ice_from(
                                           [](geo::LonLat p, double) {
                                             return std::abs(p.lon_deg + 53.0) < 0.26 && p.lat_deg < 69.15
                                                        ? 0.9
                                                        : 0.0;
                                           },
                                           {0.0}, 1.0)};
  PlanRequest request = eastward_request();
  request.under_ice.max_time_without_surfacing = core::Seconds{6.0 * 3600.0};

  const auto plan = plan_route(environment, request, {}, {});

  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->optimality_gap.has_value());
  EXPECT_NE(plan->optimality_gap_reason.find("without surfacing"), std::string::npos)
      << plan->optimality_gap_reason;
}

TEST(Optimality, IsLeftOutWhenNotAskedFor) {
  PlanRequest request = eastward_request();
  request.optimality_gap = false;

  const auto plan = plan_route({}, request, {}, {});

  ASSERT_TRUE(plan.has_value());
  EXPECT_FALSE(plan->optimality_gap.has_value());
  EXPECT_EQ(plan->optimality_gap_reason, "not asked for");
}

}  // namespace
}  // namespace floeplan::planning::optimal_control::optimality_test
