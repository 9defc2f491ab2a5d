#include "engine/planning/diagnosis/way_trials.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/plan_route.hpp"
#include "engine/planning/planner/strategies.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::diagnosis::way_trials_test {
namespace {

using support::currents_from;
using support::eastward_request;

/// Eddies that turn with a tide. A slow vehicle cannot cross them everywhere.
ocean::Environment eddies(std::mt19937_64& rng) {
  const double strength = support::uniform(rng, 0.1, 0.5);
  const double phase = support::uniform(rng, 0.0, 6.0);
  ocean::Environment environment;
  environment.currents = currents_from(
      [=](geo::LonLat p, double hour) {
        return geo::VelocityEn{{strength * std::sin(5.0 * p.lat_deg + 0.5 * hour + phase)},
                               {strength * std::cos(3.0 * p.lon_deg + phase)}};
      },
      72);
  const int bergs = support::uniform_int(rng, 0, 12);
  for (int i = 0; i < bergs; ++i) {
    environment.icebergs.push_back(
        support::iceberg_at({support::uniform(rng, -53.3, -52.7), support::uniform(rng, 68.8, 69.2)}, 300.0));
    environment.icebergs.back().id = std::to_string(i);
  }
  return environment;
}

PlanRequest plain_request(double speed_m_s) {
  PlanRequest request = eastward_request();
  request.vehicle.speed_through_water = {speed_m_s};
  request.spacing_along = core::Metres{2000.0};
  request.refine = false;
  request.optimality_gap = false;
  return request;
}

TEST(WayTrials, AnswerAsThePlannerDoes) {
  support::for_each_seed(6, [](std::mt19937_64& rng) {
    const ocean::Environment environment = eddies(rng);
    const PlanRequest request = plain_request(support::uniform(rng, 0.15, 0.5));
    WayTrials trials{environment, {}, 1'000'000'000};

    const TrialOutcome outcome = trials(request);

    const auto plan = planner::try_to_plan(environment, request, {}, {});
    if (plan) {
      EXPECT_EQ(outcome, TrialOutcome::possible);
    } else {
      EXPECT_EQ(outcome, plan.error().search_cut_short ? TrialOutcome::not_known : TrialOutcome::impossible);
    }
  });
}

TEST(WayTrials, NeverDoMoreWorkThanTheyMay) {
  support::for_each_seed(2, [](std::mt19937_64& rng) {
    const ocean::Environment environment = eddies(rng);
    const std::int64_t most_work = support::uniform_int(rng, 1, 150'000);
    WayTrials trials{environment, {}, most_work};

    bool told_nothing = false;
    for (int i = 0; i < 10; ++i) {
      told_nothing = trials(plain_request(0.12)) == TrialOutcome::not_known || told_nothing;
      ASSERT_GE(trials.left(), 0);
    }

    EXPECT_TRUE(told_nothing) << "ten trials of this kind take more than was set aside";
  });
}

TEST(WayTrials, LayOutNoSeaThatTakesMoreThanTheirShare) {
  // Ten steps of 100 km to either side. The grid has few places, far apart, but the data between them are used.
  std::mt19937_64 rng{7};
  ocean::Environment environment = eddies(rng);
  environment.bathymetry = support::bathymetry_from([](geo::LonLat) { return 300.0; });
  PlanRequest wide = plain_request(0.12);
  wide.spacing_along = core::Metres{100'000.0};
  constexpr std::int64_t most_work = 8'000'000;
  WayTrials trials{environment, {}, most_work};

  EXPECT_EQ(trials(wide), TrialOutcome::not_known);

  EXPECT_EQ(trials.left(), most_work) << "told before anything is laid out";
  wide.spacing_along = core::Metres{2000.0};
  EXPECT_NE(trials(wide), TrialOutcome::not_known);
}

TEST(WayTrials, SpendTheSameOnTheSameTrial) {
  support::for_each_seed(2, [](std::mt19937_64& rng) {
    const ocean::Environment environment = eddies(rng);
    const PlanRequest request = plain_request(0.2);
    WayTrials once{environment, {}, 1'500'000};
    WayTrials again{environment, {}, 1'500'000};

    EXPECT_EQ(once(request), again(request));
    EXPECT_EQ(once.left(), again.left());
  });
}

}  // namespace
}  // namespace floeplan::planning::diagnosis::way_trials_test
