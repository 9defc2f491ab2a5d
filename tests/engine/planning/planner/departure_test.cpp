#include "engine/planning/planner/departure.hpp"

#include <gtest/gtest.h>

#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"
#include "tests/support/backwards.hpp"
#include "tests/support/done_elsewhere.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::planner::departure_test {
namespace {

using support::currents_from;

PlanRequest window_request(double hours, double step_s) {
  PlanRequest request = support::eastward_request();
  request.spacing_along = core::Metres{2000.0};
  request.refine = false;
  request.departures.until = request.depart + core::Seconds{3600.0 * hours};
  request.departures.step = core::Seconds{step_s};
  return request;
}

geo::VelocityEn tide(geo::LonLat place, double hour) {
  const double phase = 2.0 * 3.14159265358979 * hour / 12.42;
  return {{0.15 * std::cos(phase)}, {0.2 * std::sin(phase + place.lon_deg)}};
}

std::vector<DepartureOutcome> curve(const ocean::Environment& environment, const PlanRequest& request) {
  return compare_departures(environment, request, {}, {}).value();
}

PlanRequest alone(const PlanRequest& request, core::UtcTime depart) {
  PlanRequest result = request;
  result.depart = depart;
  result.departures = {};
  return result;
}

/// Law: the curve shows for each departure the result of a plan for it alone.
void expect_brute_force(const ocean::Environment& environment, const PlanRequest& request) {
  for (const DepartureOutcome& outcome : curve(environment, request)) {
    const auto plan = plan_route(environment, alone(request, outcome.departure), {}, {});
    ASSERT_EQ(outcome.travel_time.has_value(), plan.has_value());
    if (plan) {
      // The plan joins straight runs of legs: it is the same route, integrated in fewer pieces.
      EXPECT_NEAR(outcome.travel_time->count(), plan->travel_time().count(),
                  2e-4 * plan->travel_time().count());
      EXPECT_NEAR(outcome.energy->value, plan->energy->use.total().value,
                  1e-3 * plan->energy->use.total().value);
    } else {
      EXPECT_EQ(outcome.closed->reason, plan.error().reason);
    }
  }
}

TEST(CompareDepartures, EqualsPlanningForEachDepartureAlone) {
  support::for_each_seed(2, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.28);
    const double strength_m_s = support::uniform(rng, 0.1, 0.25);
    const auto currents = currents_from(
        [&](geo::LonLat p, double hour) {
          return geo::VelocityEn{{strength_m_s * std::cos(hour / 2.0 + phase)},
                                 {strength_m_s * std::sin(hour / 3.0 + 4.0 * p.lon_deg)}};
        },
        120);
    expect_brute_force({.currents = currents}, window_request(12.0, 10800.0));
  });
}

TEST(CompareDepartures, EqualsPlanningAloneWhereTheCurrentClosesLegsAndDataEnd) {
  const auto currents = currents_from(
      [](geo::LonLat p, double hour) {
        const bool strait = std::abs(p.lon_deg + 53.0) < 0.2;
        return geo::VelocityEn{{strait ? -0.6 * std::abs(std::sin(hour / 4.0)) : 0.0},
                               {0.1 * std::sin(hour)}};
      },
      60);
  PlanRequest request = window_request(48.0, 24.0 * 3600.0);
  request.spacing_along = core::Metres{4000.0};
  expect_brute_force({.currents = currents}, request);
}

TEST(CompareDepartures, EqualsPlanningAloneWithPlacesToVisit) {
  PlanRequest request = window_request(6.0, 7200.0);
  request.via = {{-53.2, 69.08}, {-52.8, 68.95}};
  expect_brute_force({.currents = currents_from(tide, 120)}, request);
}

TEST(CompareDepartures, EqualsPlanningAloneAlongTheStraightLine) {
  PlanRequest request = window_request(12.0, 7200.0);
  request.method = Method::direct;
  expect_brute_force({.currents = currents_from(tide, 120)}, request);
}

TEST(CompareDepartures, EqualsPlanningAloneOverASeaBedThatCostsEnergy) {
  const auto banks = support::bathymetry_from([](geo::LonLat place) {
    return 260.0 + 180.0 * std::sin(40.0 * place.lon_deg) * std::cos(90.0 * place.lat_deg);
  });
  expect_brute_force({.currents = currents_from(tide, 120), .bathymetry = banks},
                     window_request(6.0, 7200.0));
}

TEST(CompareDepartures, EqualsPlanningAloneWhileABergGoesByForDays) {
  support::for_each_seed(3, [](std::mt19937_64& rng) {
    PlanRequest request = window_request(120.0, 12.0 * 3600.0);
    request.from = {-53.0, 69.03};
    request.to = {-53.0, 68.985};
    request.spacing_along = core::Metres{250.0};
    request.icebergs.max_inflation = core::Metres{500.0};
    // The berg crosses the route after the two days for which drift would be followed without the window.
    const double speed_m_s = support::uniform(rng, 0.02, 0.06);
    const core::Metres upstream{speed_m_s * 3600.0 * support::uniform(rng, 54.0, 96.0)};
    const geo::LonLat seen = geo::geodesic_destination({-53.0, 69.0}, geo::Bearing::degrees(270.0), upstream);

    expect_brute_force({.icebergs = {drifting_berg(seen, 300.0, speed_m_s, 90.0)}}, request);
  });
}

TEST(CompareDepartures, TakeTheWayOfLeastCostWhereTheObjectiveIsEnergy) {
  const auto banks = support::bathymetry_from(
      [](geo::LonLat place) { return std::abs(place.lat_deg - 69.0) < 0.05 ? 60.0 : 400.0; });
  const ocean::Environment environment{.currents = currents_from(tide, 120), .bathymetry = banks};
  PlanRequest request = window_request(4.0, 7200.0);
  const auto fastest = curve(environment, request);
  request.energy.objective = energy_objective;
  const auto cheapest = curve(environment, request);

  for (std::size_t i = 0; i < cheapest.size(); ++i) {
    EXPECT_LT(*cheapest[i].energy, *fastest[i].energy);
    EXPECT_GE(*cheapest[i].travel_time * (1.0 + 1e-4), *fastest[i].travel_time);
  }
}

TEST(CompareDepartures, LooksAtEveryStepOfTheWindowItsEndIncluded) {
  const auto outcomes = curve({}, window_request(3.0, 3600.0));

  ASSERT_EQ(outcomes.size(), 4U);
  EXPECT_EQ(outcomes.front().departure, support::eastward_request().depart);
  EXPECT_EQ(outcomes.back().departure, *window_request(3.0, 3600.0).departures.until);
}

TEST(CompareDepartures, SaysOfEachDepartureWhyItIsClosed) {
  const auto outcomes = curve({.currents = currents_from(tide, 48)}, window_request(24.0, 12.0 * 3600.0));

  ASSERT_EQ(outcomes.size(), 3U);
  EXPECT_TRUE(outcomes[0].travel_time.has_value());
  ASSERT_TRUE(outcomes[2].closed.has_value());
  EXPECT_EQ(outcomes[2].closed->reason, Reason::outside_data);
}

TEST(CompareDepartures, ArriveInTheOrderOfDepartureUnderFifo) {
  const auto outcomes = curve({.currents = currents_from(tide, 120)}, window_request(24.0, 7200.0));

  for (std::size_t i = 1; i < outcomes.size(); ++i) {
    EXPECT_GE(outcomes[i].arrival() + core::Seconds{30.0}, outcomes[i - 1].arrival());
  }
}

/// An area round the start that is closed until the hour.
ocean::Zone closed_start_until(const PlanRequest& request, double hour) {
  const double west = request.from.lon_deg - 0.05;
  const double south = request.from.lat_deg - 0.02;
  return {.name = "exercise",
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer =
                       {{west, south}, {west + 0.1, south}, {west + 0.1, south + 0.04}, {west, south + 0.04}},
                   .holes = {}},
          .from = {},
          .until = request.depart + core::Seconds{3600.0 * hour}};
}

TEST(CompareDepartures, AskOfEachDepartureAloneWhetherItsStartIsClosed) {
  PlanRequest request = window_request(12.0, 10'800.0);
  request.zones = {closed_start_until(request, 4.0)};

  const auto outcomes = curve({.currents = currents_from(tide, 96)}, request);

  ASSERT_EQ(outcomes.size(), 5U);
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    EXPECT_EQ(outcomes[i].closed.has_value(), i < 2) << "departure " << i;
  EXPECT_EQ(outcomes[1].closed->reason, Reason::start_in_zone);
  EXPECT_NE(outcomes[1].closed->explanation().find("until"), std::string::npos);
  EXPECT_EQ(outcomes[1].closed->when, outcomes[1].departure);
  expect_brute_force({.currents = currents_from(tide, 96)}, request);
}

TEST(CompareDepartures, AskOfEachDepartureAloneWhetherAnIcebergCoversItsStart) {
  PlanRequest request = window_request(24.0, 21'600.0);
  ocean::Environment environment{
      .currents = currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.0}, {0.15}}; }, 120)};
  environment.icebergs = {support::iceberg_at(request.from, 200.0)};
  request.icebergs.max_inflation = core::Metres{0.0};

  const auto outcomes = curve(environment, request);

  EXPECT_EQ(outcomes.front().closed->reason, Reason::start_near_iceberg);
  EXPECT_TRUE(outcomes.back().travel_time.has_value());
  expect_brute_force(environment, request);
}

/// A stream against the route until an hour, and with it afterwards; or the other way round.
std::shared_ptr<const ocean::CurrentGrid> turning_stream(double before_m_s, double after_m_s) {
  return currents_from(
      [=](geo::LonLat, double hour) {
        return geo::VelocityEn{{hour < 48.0 ? before_m_s : after_m_s}, {0.0}};
      },
      200);
}

TEST(CompareDepartures, WeighAllMembersWhereTheObjectiveIsRobust) {
  ocean::Environment environment{.currents = turning_stream(0.1, 0.0)};
  environment.members = {environment.currents, turning_stream(-0.2, 0.15), turning_stream(-0.2, 0.15)};
  PlanRequest request = window_request(72.0, 72.0 * 3600.0);
  request.spacing_along = core::Metres{4000.0};
  EXPECT_EQ(best_departure(curve(environment, request)), 0U) << "the first member wants to leave at once";
  request.uncertainty.objective = RobustObjective::mean;

  const auto outcomes = curve(environment, request);

  EXPECT_EQ(best_departure(outcomes), 1U);
  for (const DepartureOutcome& outcome : outcomes) {
    double sum_s = 0.0;
    for (const auto& member : environment.members) {
      const auto plan = plan_route({.currents = member}, alone(request, outcome.departure), {}, {});
      ASSERT_TRUE(plan.has_value());
      sum_s += plan->travel_time().count();
    }
    EXPECT_NEAR(outcome.robust_cost.value(), sum_s / 3.0, 1e-3 * sum_s);
    EXPECT_EQ(outcome.members_closed, 0U);
  }
}

TEST(CompareDepartures, AreTheSameToTheLastBitOnHoweverManyThreads) {
  ocean::Environment environment{.currents = currents_from(tide, 120)};
  environment.members = {environment.currents, turning_stream(-0.2, 0.15)};
  PlanRequest request = window_request(24.0, 3600.0);
  for (const RobustObjective objective : {RobustObjective::none, RobustObjective::mean}) {
    request.uncertainty.objective = objective;
    const auto in_order = curve(environment, request);

    const auto at_once = compare_departures(environment, request, {}, {}, support::Backwards{}).value();

    ASSERT_EQ(at_once.size(), 25U);
    for (std::size_t i = 0; i < at_once.size(); ++i) {
      EXPECT_EQ(at_once[i].travel_time, in_order[i].travel_time) << i;
      EXPECT_EQ(at_once[i].energy, in_order[i].energy) << i;
      EXPECT_EQ(at_once[i].robust_cost, in_order[i].robust_cost) << i;
    }
  }
}

/// Law: departures that other processes have searched give the same outcomes, to the last bit of a refusal's text.
TEST(CompareDepartures, AreTheSameWhenAllOfThemWereSearchedElsewhere) {
  ocean::Environment environment{.currents =
                                     currents_from(tide, 44)};  // the data end before the late arrivals
  environment.members = {environment.currents, turning_stream(-0.2, 0.15)};
  PlanRequest request = window_request(24.0, 3600.0);
  for (const RobustObjective objective : {RobustObjective::none, RobustObjective::mean}) {
    request.uncertainty.objective = objective;
    support::KeptParts kept;
    const auto here = compare_departures(environment, request, {}, {}, support::KeepsParts{kept}).value();
    double share = 0.0;

    const auto elsewhere = compare_departures(
        environment, request, {}, [&](std::string_view, double done) { share = done; },
        support::DoneElsewhere{kept});

    ASSERT_TRUE(elsewhere.has_value());
    EXPECT_DOUBLE_EQ(share, 1.0);
    std::size_t closed = 0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      EXPECT_EQ((*elsewhere)[i].travel_time, here[i].travel_time) << i;
      EXPECT_EQ((*elsewhere)[i].energy, here[i].energy) << i;
      EXPECT_EQ((*elsewhere)[i].robust_cost, here[i].robust_cost) << i;
      ASSERT_EQ((*elsewhere)[i].closed.has_value(), here[i].closed.has_value()) << i;
      if (!here[i].closed) continue;
      ++closed;
      EXPECT_EQ((*elsewhere)[i].closed->explanation(), here[i].closed->explanation()) << i;
      EXPECT_EQ((*elsewhere)[i].closed->when, here[i].closed->when) << i;
    }
    EXPECT_GT(closed, 0U);
    EXPECT_LT(closed, here.size());
  }
}

TEST(CompareDepartures, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();

  const auto found = compare_departures({}, window_request(3.0, 3600.0), source.get_token(), {});

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::cancelled);
}

TEST(PlanWindow, PlansTheBestDepartureAsForItAlone) {
  const ocean::Environment environment{.currents = currents_from(tide, 120)};
  PlanRequest request = window_request(12.0, 3600.0);
  request.refine = true;
  request.leg_tolerance = 0.0;  // the curve gives nothing for fewer legs

  const WindowPlan window = plan_window(environment, request, {}, {});

  ASSERT_TRUE(window.plan.has_value());
  const DepartureOutcome& best = window.departures[best_departure(window.departures).value()];
  EXPECT_EQ(window.plan->departure, best.departure);
  EXPECT_EQ(window.plan->arrival, plan_route(environment, alone(request, best.departure), {}, {})->arrival);
  EXPECT_LE(window.plan->travel_time(), *best.travel_time * (1.0 + 2e-4));
}

TEST(PlanWindow, OfARobustObjectiveTakesTheDepartureWhosePlanIsBestAndNotWhoseMembersAre) {
  // At first each member has a different helpful current. Later all have the same weak one.
  const auto stream = [](double middle_lat) {
    return currents_from(
        [=](geo::LonLat place, double hour) {
          const double across = (place.lat_deg - middle_lat) / 0.04;
          const double of_member = 0.5 * std::exp(-across * across) - 0.15;
          return geo::VelocityEn{{hour < 72.0 ? of_member : 0.02}, {0.0}};
        },
        200);
  };
  ocean::Environment environment{.currents = stream(68.95)};
  environment.members = {environment.currents, stream(69.05)};
  PlanRequest request = window_request(72.0, 72.0 * 3600.0);
  request.spacing_along = core::Metres{2000.0};
  request.refine = false;
  request.uncertainty.objective = RobustObjective::mean;
  const auto mean_of = [&](const DepartureOutcome& outcome) {
    return *plan_route(environment, leaving_at(request, outcome.departure), {}, {})
                ->uncertainty->spread.mean();
  };

  const WindowPlan window = plan_window(environment, request, {}, {});

  ASSERT_TRUE(window.plan.has_value());
  const auto& outcomes = window.departures;
  ASSERT_LT(curve(environment, request)[0].robust_cost, curve(environment, request)[1].robust_cost)
      << "a sea in which the members' own ways mislead";
  ASSERT_LT(mean_of(outcomes[1]), mean_of(outcomes[0]));
  EXPECT_EQ(window.plan->departure, outcomes[1].departure);
  EXPECT_EQ(best_departure(outcomes), 1U) << "the curve that is published says why";
}

TEST(PlanWindow, GivesTheReasonOfTheFirstDepartureWhenEveryOneIsClosed) {
  const WindowPlan window =
      plan_window({.currents = currents_from(tide, 12)}, window_request(6.0, 3600.0), {}, {});

  ASSERT_FALSE(window.plan.has_value());
  EXPECT_EQ(window.plan.error().reason, Reason::outside_data);
  EXPECT_EQ(window.departures.size(), 7U);
}

TEST(PlanWindow, SaysWhichDeparturesItDidNotTryToPlan) {
  PlanRequest request = window_request(30.0, 3600.0);
  request.method = Method::direct;
  request.energy.require_battery = true;
  request.vehicle.energy.battery = {1e5};

  const WindowPlan found = plan_window({.currents = currents_from(tide, 120)}, request, {}, {});

  ASSERT_FALSE(found.plan.has_value());
  EXPECT_EQ(found.plan.error().reason, Reason::energy_exceeded);
  EXPECT_NE(found.plan.error().explanation().find("24 of 31 departures were tried"), std::string::npos)
      << found.plan.error().explanation();
}

TEST(BestDeparture, IsTheFirstOfTheFastest) {
  std::vector<DepartureOutcome> outcomes(4);
  outcomes[1].travel_time = core::Seconds{50.0};
  outcomes[2].travel_time = core::Seconds{40.0};
  outcomes[3].travel_time = core::Seconds{40.0};

  EXPECT_EQ(best_departure(outcomes), 2U);
  EXPECT_EQ(best_departure({}), std::nullopt);
}

TEST(BestDeparture, IsTheFirstOfThoseThatDifferByRounding) {
  const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
  std::vector<DepartureOutcome> outcomes;
  for (int i = 0; i < 4; ++i)
    outcomes.push_back({.departure = start + core::Seconds{3600.0 * i},
                        .travel_time = core::Seconds{50'000.0 * (1.0 - 1e-12 * i)}});

  EXPECT_EQ(best_departure(outcomes), 0U);
}

TEST(BestDeparture, IsOneThatMostMembersLetThrough) {
  const core::UtcTime start = core::from_unix_seconds(support::sea_start_s);
  const std::vector<DepartureOutcome> outcomes{
      {.departure = start, .travel_time = core::Seconds{10.0}, .robust_cost = 10.0, .members_closed = 1},
      {.departure = start, .travel_time = core::Seconds{20.0}, .robust_cost = 20.0, .members_closed = 0},
      {.departure = start, .travel_time = core::Seconds{15.0}, .robust_cost = 15.0, .members_closed = 0}};

  EXPECT_EQ(best_departure(outcomes), 2U);
}

TEST(BestDeparture, DrawsLeastWhereTheObjectiveIsEnergy) {
  std::vector<DepartureOutcome> outcomes(2);
  outcomes[0].travel_time = core::Seconds{40.0};
  outcomes[0].energy = core::Joules{9.0};
  outcomes[1].travel_time = core::Seconds{50.0};
  outcomes[1].energy = core::Joules{8.0};

  EXPECT_EQ(best_departure(outcomes), 0U);
  EXPECT_EQ(best_departure(outcomes, energy_objective), 1U);
}

}  // namespace
}  // namespace floeplan::planning::planner::departure_test
