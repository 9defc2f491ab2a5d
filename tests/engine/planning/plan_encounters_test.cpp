#include <gtest/gtest.h>

#include <algorithm>

#include "engine/planning/obstacles/encounter_map.hpp"
#include "engine/planning/plan_route.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::plan_encounters_test {
namespace {

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

/// A berg beside the straight line. Its position error is 3 km, and does not widen its disc.
Scene badly_known_berg() {
  PlanRequest request = support::eastward_request();
  request.icebergs.drift = false;
  request.icebergs.max_inflation = core::Metres{0.0};
  ocean::Environment environment;
  environment.icebergs = {support::iceberg_at({-53.0, 68.995}, 100.0)};
  environment.icebergs[0].position_uncertainty = core::Metres{3000.0};
  return {request, environment};
}

TEST(EncounterWeight, IsZeroByDefaultAndThenNothingIsTraded) {
  const auto [request, environment] = badly_known_berg();

  const Result<Plan> result = plan(environment, request);

  ASSERT_TRUE(result);
  EXPECT_FALSE(result->encounter_trade);
  EXPECT_GT(*result->iceberg_encounters, 0.05);
}

TEST(EncounterWeight, LeadsFartherFromABergThatIsNotWellKnown) {
  auto [request, environment] = badly_known_berg();
  const Result<Plan> before = plan(environment, request);
  request.icebergs.encounter_weight = core::Seconds{24.0 * hour_s};

  const Result<Plan> after = plan(environment, request);

  ASSERT_TRUE(before && after && after->encounter_trade);
  EXPECT_LT(*after->iceberg_encounters, 0.5 * *before->iceberg_encounters);
  EXPECT_GT(after->arrival, before->arrival);
  EXPECT_EQ(after->encounter_trade->weight, request.icebergs.encounter_weight);
  EXPECT_EQ(after->encounter_trade->time_before, before->travel_time());
  EXPECT_EQ(after->encounter_trade->encounters_before, *before->iceberg_encounters);
  const core::Seconds paid = after->travel_time() - before->travel_time();
  const double avoided = *before->iceberg_encounters - *after->iceberg_encounters;
  EXPECT_LE(paid.count(), request.icebergs.encounter_weight.count() * avoided);
}

TEST(EncounterWeight, NeverMakesTheChosenPlanExpectMoreEncounters) {
  int fewer = 0;
  support::for_each_seed(24, [&](std::mt19937_64& rng) {
    auto [request, environment] = random_scene(rng);
    for (ocean::Iceberg& berg : environment.icebergs)
      berg.position_uncertainty = core::Metres{support::uniform(rng, 500.0, 3000.0)};
    request.icebergs.max_inflation = core::Metres{0.0};
    const Result<Plan> before = plan(environment, request);
    request.icebergs.encounter_weight = core::Seconds{support::uniform(rng, 1.0, 200.0) * hour_s};

    const Result<Plan> after = plan(environment, request);

    ASSERT_EQ(before.has_value(), after.has_value());
    if (!before) return;
    EXPECT_LE(*after->iceberg_encounters, *before->iceberg_encounters);
    fewer += *after->iceberg_encounters < *before->iceberg_encounters ? 1 : 0;
    const Objective objective = request.objective();
    EXPECT_LE(objective.cost(after->travel_time(), {}, *after->iceberg_encounters),
              objective.cost(before->travel_time(), {}, *before->iceberg_encounters));
    EXPECT_GT(least_gap_m(*after, environment, request.icebergs), -tolerance_m);
  });
  EXPECT_GT(fewer, 4);
}

TEST(EncounterWeight, IsRefusedWhereTimeHasNone) {
  PlanRequest request = support::eastward_request();
  request.icebergs.encounter_weight = core::Seconds{3600.0};
  EXPECT_TRUE(request.violations().empty());
  request.energy.objective = energy_objective;
  EXPECT_EQ(request.violations().at(0).field, "/encounter_weight_s");
}

TEST(EncounterMap, ReadsFromItsLatticeWhatIsExpectedOfAMove) {
  support::for_each_seed(20, [](std::mt19937_64& rng) {
    PlanRequest request = support::eastward_request();
    request.icebergs.drift = false;
    request.icebergs.max_inflation = core::Metres{0.0};
    ocean::Environment environment;
    environment.icebergs = {support::iceberg_at(
        {support::uniform(rng, -53.2, -52.8), support::uniform(rng, 68.95, 69.05)}, 100.0)};
    environment.icebergs[0].position_uncertainty = core::Metres{support::uniform(rng, 3000.0, 6000.0)};
    const geo::LocalProjection projection{{-53.0, 69.0}};
    const plane::PlaneBox area{{-20'000.0, -12'000.0}, {20'000.0, 12'000.0}};
    const core::Seconds day{24.0 * hour_s};
    const obstacles::IcebergDiscs discs{environment, request.icebergs, projection, area, request.depart, day};
    const core::MetresPerSecond speed{0.35};
    const obstacles::EncounterMap map{discs, area, day, speed, {}};
    const geo::PlanePoint a{support::uniform(rng, -15'000.0, 0.0), support::uniform(rng, -8'000.0, 8'000.0)};
    const geo::PlanePoint b{support::uniform(rng, 0.0, 15'000.0), support::uniform(rng, -8'000.0, 8'000.0)};
    const core::Seconds time{std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / speed.value};

    const double read = map.along(a, b, core::Seconds{0.0}, time);

    const double exact = discs.expected_encounters({a, b, 0.0, time.count()});
    EXPECT_NEAR(read, exact, 0.05 * exact + 1e-4);
  });
}

}  // namespace
}  // namespace floeplan::planning::plan_encounters_test
