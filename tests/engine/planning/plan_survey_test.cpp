#include <gtest/gtest.h>

#include <algorithm>

#include "engine/messages/sentence.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_survey_test {
namespace {

using support::currents_from;
using support::eastward_request;

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double phase = 2.0 * 3.14159265358979 * hour / 12.42;
  return {{0.2 * std::cos(phase)}, {0.2 * std::sin(phase + 3.0 * place.lon_deg)}};
}

PlanRequest survey() {
  PlanRequest request = eastward_request();
  request.to = {-53.45, 69.02};
  request.spacing_along = core::Metres{2000.0};
  request.via = {{-53.0, 69.15}, {-52.8, 69.0}, {-53.3, 69.15}};
  request.via_in_best_order = true;
  request.refine = false;
  return request;
}

TEST(PlanSurvey, IsAsFastAsTheFastestOfAllOrdersPlannedOneByOne) {
  const ocean::Environment environment{.currents = currents_from(tide, 240)};
  const PlanRequest request = survey();

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_TRUE(found.has_value());
  PlanRequest each = request;
  each.via_in_best_order = false;
  std::vector<std::size_t> order{0, 1, 2};
  double best_s = INFINITY;
  do {
    for (std::size_t i = 0; i < order.size(); ++i) each.via[i] = request.via[order[i]];
    const auto plan = plan_route(environment, each, {}, {});
    if (plan) best_s = std::min(best_s, plan->travel_time().count());
  } while (std::ranges::next_permutation(order).found);
  // The order is chosen by travel times on coarse grids.
  EXPECT_LE(found->travel_time().count(), 1.01 * best_s);
  ASSERT_TRUE(found->via_order.has_value());
  EXPECT_TRUE(found->via_order->exact);
}

TEST(PlanSurvey, VisitsAPlaceBesideAnIcebergOnceItHasDriftedAway) {
  const auto northwards = [](geo::LonLat, double) { return geo::VelocityEn{{0.0}, {0.03}}; };
  const ocean::Environment environment{.currents = currents_from(northwards, 240),
                                       .icebergs = {support::iceberg_at({-53.42, 69.0}, 100.0)}};
  PlanRequest request = survey();
  request.from = {-53.5, 69.0};
  request.to = {-53.5, 69.01};
  request.via = {{-53.42, 69.0}, {-53.1, 69.0}, {-53.2, 69.05}};
  request.icebergs.max_inflation = core::Metres{500.0};

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  ASSERT_TRUE(found->via_order.has_value());
  EXPECT_NE(found->via_order->vias.front(), 0U);
  EXPECT_TRUE(std::ranges::none_of(messages::sentences(found->messages), [](const std::string& warning) {
    return warning.find("round an obstacle that clears later") != std::string::npos;
  })) << "it comes back to its start because it has places to visit";
}

/// An area around a place that closes while the vehicle may be there.
ocean::Zone closed_about(std::mt19937_64& rng, geo::LonLat place, core::UtcTime depart) {
  const core::UtcTime from = depart + core::Seconds{3600.0 * support::uniform(rng, 0.0, 10.0)};
  const geo::Polygon area{{{place.lon_deg - 0.06, place.lat_deg - 0.03},
                           {place.lon_deg + 0.06, place.lat_deg - 0.03},
                           {place.lon_deg + 0.06, place.lat_deg + 0.03},
                           {place.lon_deg - 0.06, place.lat_deg + 0.03}},
                          {}};
  return {.name = "survey area",
          .kind = ocean::ZoneKind::no_go,
          .area = area,
          .from = from,
          .until = from + core::Seconds{3600.0 * support::uniform(rng, 20.0, 50.0)}};
}

TEST(PlanSurvey, IsPossibleAndAsEarlyWhereAreasCloseAndOpenWhateverTheOrderGiven) {
  int possible = 0;
  support::for_each_seed(4, [&possible](std::mt19937_64& rng) {
    PlanRequest request = survey();
    request.vehicle.speed_through_water = {0.6};
    const auto anywhere = [&rng] {
      return geo::LonLat{support::uniform(rng, -53.6, -52.9), support::uniform(rng, 68.9, 69.2)};
    };
    request.from = anywhere();
    request.to = anywhere();
    for (geo::LonLat& via : request.via) via = anywhere();
    request.zones = {closed_about(rng, request.via[0], request.depart),
                     closed_about(rng, request.via[1], request.depart)};
    request.holds.longest = core::Seconds{support::uniform_int(rng, 0, 1) * 200'000.0};
    PlanRequest given = request;
    given.via_in_best_order = false;
    std::vector<std::size_t> order{0, 1, 2};
    do {
      for (std::size_t i = 0; i < order.size(); ++i) given.via[i] = request.via[order[i]];
      const auto as_given = planner::try_to_plan({}, given, {}, {});
      if (!as_given) continue;
      ++possible;
      PlanRequest best = given;
      best.via_in_best_order = true;

      const auto found = planner::try_to_plan({}, best, {}, {});

      ASSERT_TRUE(found.has_value()) << found.error().explanation();
      EXPECT_LE(found->travel_time().count(), 1.05 * as_given->travel_time().count());
    } while (std::ranges::next_permutation(order).found);
  });
  EXPECT_GT(possible, 0);
}

TEST(PlanSurvey, IsMadePossibleByEachChangeThatARefusalNames) {
  int named = 0;
  support::for_each_seed(3, [&named](std::mt19937_64& rng) {
    PlanRequest request = survey();
    request.vehicle.speed_through_water = {0.6};
    request.via.pop_back();
    request.via[0] = {support::uniform(rng, -53.4, -53.2), 69.0};
    const core::UtcTime depart = request.depart;
    request.zones = {closed_about(rng, request.via[0], depart), closed_about(rng, request.via[0], depart)};
    for (ocean::Zone& zone : request.zones) {
      zone.from = depart + core::Seconds{3600.0};
      zone.until = depart + core::Seconds{3600.0 * support::uniform(rng, 60.0, 90.0)};
    }
    request.zones[1].area = {{{-52.95, 69.05}, {-52.85, 69.05}, {-52.85, 69.1}, {-52.95, 69.1}}, {}};

    request.holds.longest = core::Seconds{0.0};

    const auto found = plan_route({}, request, {}, {});

    ASSERT_FALSE(found.has_value());
    for (const Change& change : found.error().changes) {
      PlanRequest changed = request;
      if (change.input == "areas/features/0") changed.zones.erase(changed.zones.begin());
      if (change.input == "areas/features/1") changed.zones.pop_back();
      if (change.input == "max_loiter_s") changed.holds.longest = core::Seconds{std::get<double>(change.to)};
      if (change.input == "depart") changed.depart = std::get<core::UtcTime>(change.to);
      if (change.input == "speed_m_s") changed.vehicle.speed_through_water = {std::get<double>(change.to)};
      if (change.input == "spacing_m") changed.spacing_along = core::Metres{std::get<double>(change.to)};
      EXPECT_TRUE(plan_route({}, changed, {}, {}).has_value()) << change.text;
      ++named;
    }
  });
  EXPECT_GT(named, 0);
}

/// A vehicle that goes there first cannot leave: the area closes before the vehicle is out of it.
TEST(PlanSurvey, DoesNotCallAtAPlaceThatItCannotLeaveInTime) {
  PlanRequest request = survey();
  request.from = {-53.5, 69.0};
  request.to = {-53.2, 69.05};
  request.via = {{-53.4, 69.0}, {-53.0, 69.0}};
  request.vehicle.speed_through_water = {0.5};
  const core::Seconds there = core::Seconds{3960.0 / 0.5};
  request.zones = {{.name = "survey area",
                    .kind = ocean::ZoneKind::no_go,
                    .area = {{{-53.48, 68.95}, {-53.32, 68.95}, {-53.32, 69.05}, {-53.48, 69.05}}, {}},
                    .from = request.depart + there + core::Seconds{1800.0},
                    .until = request.depart + core::Seconds{20.0 * 3600.0}}};

  const auto found = planner::try_to_plan({}, request, {}, {});

  ASSERT_TRUE(found.has_value()) << found.error().explanation();
  ASSERT_TRUE(found->via_order.has_value());
  EXPECT_EQ(found->via_order->vias, (std::vector<std::size_t>{1, 0}));
}

TEST(PlanSurvey, VisitsEveryPlaceInTheOrderThatItNames) {
  const ocean::Environment environment{.currents = currents_from(tide, 240)};
  const PlanRequest request = survey();

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_TRUE(found && found->via_order);
  auto from = found->waypoints.begin();
  for (const std::size_t via : found->via_order->vias) {
    from = std::find_if(from, found->waypoints.end(), [&](const Waypoint& waypoint) {
      return std::abs(waypoint.place.lon_deg - request.via[via].lon_deg) < 1e-6 &&
             std::abs(waypoint.place.lat_deg - request.via[via].lat_deg) < 1e-6;
    });
    ASSERT_NE(from, found->waypoints.end()) << "place " << via;
  }
}

TEST(PlanSurvey, SaysWhyWhenAPlaceCannotBeVisited) {
  PlanRequest request = survey();
  const ocean::Environment environment{.bathymetry = support::bathymetry_from(
                                           [](geo::LonLat p) { return p.lon_deg > -52.9 ? -10.0 : 300.0; })};

  const auto found = plan_route(environment, request, {}, {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::land);
}

}  // namespace
}  // namespace floeplan::planning::plan_survey_test
