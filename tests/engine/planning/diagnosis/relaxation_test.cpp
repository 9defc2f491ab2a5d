#include "engine/planning/diagnosis/relaxation.hpp"

#include <gtest/gtest.h>

#include <array>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/diagnosis/what_would_help.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/search/latest_departure.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::diagnosis::relaxation_test {
namespace {

using support::bathymetry_from;
using support::currents_from;
using support::eastward_request;

Result<Plan> plan(const ocean::Environment& environment, const PlanRequest& request) {
  return plan_route(environment, request, {}, {});
}

const Change* change_of(const Infeasible& infeasible, const std::string& input) {
  for (const Change& change : infeasible.changes) {
    if (change.input == input) return &change;
  }
  return nullptr;
}

/// An area along a meridian, 500 m wide on either side.
ocean::Zone zone_across(std::string name, double lon_deg) {
  return {.name = std::move(name),
          .kind = ocean::ZoneKind::no_go,
          .area = {.outer = {{lon_deg - 0.01, 67.6},
                             {lon_deg + 0.01, 67.6},
                             {lon_deg + 0.01, 70.4},
                             {lon_deg - 0.01, 70.4}},
                   .holes = {}},
          .from = {},
          .until = {}};
}

/// A current against the route everywhere, strong until the given hour and weak afterwards.
ocean::Environment headwind_until(double hour_of_change, double m_s = 0.6) {
  return {.currents = currents_from(
              [=](geo::LonLat, double hour) {
                return geo::VelocityEn{{hour < hour_of_change ? -m_s : -0.02}, {0.0}};
              },
              120)};
}

TEST(Relaxation, NamesTheSpeedThatIsJustEnoughAgainstACurrent) {
  const ocean::Environment environment = headwind_until(1000.0);
  PlanRequest request = eastward_request();

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::current);
  const Change* faster = change_of(found.error(), "speed_m_s");
  ASSERT_NE(faster, nullptr);
  request.vehicle.speed_through_water = {std::get<double>(faster->to)};
  EXPECT_TRUE(plan(environment, request).has_value()) << "the change that is named is enough";
  EXPECT_GT(std::get<double>(faster->to), 0.6);
  EXPECT_LT(std::get<double>(faster->to), 0.75) << "and not much more than enough";
}

TEST(Relaxation, NamesTheNextDepartureThatACurrentLetsPass) {
  // The current is so long and strong that the vehicle would drift out of every grid before it could come back.
  const ocean::Environment environment = headwind_until(26.0, 2.0);
  PlanRequest request = eastward_request();

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  const Change* later = change_of(found.error(), "depart");
  ASSERT_NE(later, nullptr);
  request.depart = std::get<core::UtcTime>(later->to);
  EXPECT_TRUE(plan(environment, request).has_value());
  EXPECT_LE(request.depart - std::get<core::UtcTime>(later->from), core::Seconds{24.0 * 3600.0});
}

TEST(Relaxation, NamesTheMarginThatLetsTheVehicleThroughBetweenIcebergs) {
  PlanRequest request = eastward_request();
  ocean::Environment environment;
  // A line of bergs of 200 m, 2.2 km apart, crosses every route: in the middle between two, 1 km is free to either side.
  for (int i = -60; i <= 60; ++i) {
    environment.icebergs.push_back(support::iceberg_at({-53.0, 69.0 + 0.0198 * i}, 200.0));
    environment.icebergs.back().id = std::to_string(i);
  }
  request.icebergs.drift = false;
  request.icebergs.margin = core::Metres{1500.0};
  request.spacing_along = core::Metres{500.0};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::iceberg);
  const Change* margin = change_of(found.error(), "margin_m");
  ASSERT_NE(margin, nullptr);
  EXPECT_LE(std::get<double>(margin->to), 1005.0);
  EXPECT_GE(std::get<double>(margin->to), 980.0) << "and not much less than is needed";
  request.icebergs.margin = core::Metres{std::get<double>(margin->to)};
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesTheOneAreaThatIsInTheWay) {
  PlanRequest request = eastward_request();
  const auto wall = [](double west, double east) {
    return geo::Polygon{.outer = {{west, 67.6}, {east, 67.6}, {east, 70.4}, {west, 70.4}}, .holes = {}};
  };
  const auto no_go = [](std::string name, geo::Polygon area) {
    return ocean::Zone{.name = std::move(name),
                       .kind = ocean::ZoneKind::no_go,
                       .area = std::move(area),
                       .from = {},
                       .until = {}};
  };
  request.zones = {no_go("harmless", wall(-50.5, -50.4)), no_go("wall", wall(-53.01, -52.99))};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::zone);
  ASSERT_FALSE(found.error().changes.empty());
  EXPECT_EQ(found.error().changes.front().input, "areas/features/1");
  EXPECT_EQ(std::get<std::string>(found.error().changes.front().from), "wall");
}

TEST(Relaxation, LeavesOutAnAreaWithAllItsPartsAndNamesItsFeature) {
  PlanRequest request = eastward_request();
  const auto part = [](double west, double east, std::size_t feature) {
    return ocean::Zone{
        .name = {},
        .kind = ocean::ZoneKind::no_go,
        .area = {.outer = {{west, 67.6}, {east, 67.6}, {east, 70.4}, {west, 70.4}}, .holes = {}},
        .from = {},
        .until = {},
        .feature = feature};
  };
  request.zones = {part(-50.5, -50.4, 0), part(-50.3, -50.2, 0), part(-53.01, -52.99, 1),
                   part(-52.81, -52.79, 1)};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  const Change* area = change_of(found.error(), "areas/features/1");
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->text, "leave out the area number 2");
  request.zones.resize(2);
  EXPECT_TRUE(plan({}, request).has_value());
}

TEST(Relaxation, MovesAStopThatIsNotUsableToTheNearestPlaceThatIs) {
  PlanRequest request = eastward_request();
  const ocean::Environment environment{
      .bathymetry = bathymetry_from([](geo::LonLat p) { return p.lon_deg < -53.3 ? 5.0 : 300.0; })};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::start_too_shallow);
  const Change* moved = change_of(found.error(), "from");
  ASSERT_NE(moved, nullptr);
  request.from = std::get<geo::LonLat>(moved->to);
  EXPECT_NEAR(request.from.lat_deg, 69.0, 0.01);
  EXPECT_TRUE(plan(environment, request).has_value());
}

/// A goal on a bank in a basin inside a ring of shallow water: the nearest deep water cannot be reached.
TEST(Relaxation, MovesAStopOnlyToWhereAWayLeads) {
  PlanRequest request = eastward_request();
  const auto depth = [&](geo::LonLat p) {
    const double off_m = geo::geodesic_between(p, request.to).length.value;
    const bool is_shoal = off_m < 3'000.0 || (off_m > 12'000.0 && off_m < 22'000.0);
    return is_shoal ? 5.0 : 300.0;
  };
  const ocean::Environment environment{.bathymetry = bathymetry_from(depth)};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::goal_too_shallow);
  const Change* moved = change_of(found.error(), "to");
  ASSERT_NE(moved, nullptr);
  const double off_m = geo::geodesic_between(std::get<geo::LonLat>(moved->to), request.to).length.value;
  EXPECT_GT(off_m, 12'000.0);
  EXPECT_LT(off_m, 30'000.0);
  request.to = std::get<geo::LonLat>(moved->to);
  EXPECT_TRUE(plan(environment, request).has_value());
}

/// The vehicle cannot leave a small basin round the start, and the goal is a bank in another: the place next to the goal that
/// it reaches lies beside the start.
TEST(Relaxation, MovesNoGoalBackToTheStart) {
  const PlanRequest request = eastward_request();
  const auto depth = [&](geo::LonLat p) {
    const double from_start_m = geo::geodesic_between(p, request.from).length.value;
    const double from_goal_m = geo::geodesic_between(p, request.to).length.value;
    return from_start_m < 4'000.0 || (from_goal_m > 2'000.0 && from_goal_m < 6'000.0) ? 300.0 : 5.0;
  };

  const auto found = plan({.bathymetry = bathymetry_from(depth)}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::goal_too_shallow);
  EXPECT_EQ(change_of(found.error(), "to"), nullptr);
}

TEST(Relaxation, MovesNoStopWhereThatDoesNotHelp) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat p) {
                                         return std::abs(p.lon_deg + 53.0) > 0.3 ? 5.0 : 300.0;
                                       })};

  const auto found = plan(environment, eastward_request());  // both ends are too shallow

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::start_too_shallow);
  EXPECT_TRUE(found.error().changes.empty());
}

TEST(Relaxation, NamesZonesOfTheStoreThatAreInTheWay) {
  ocean::Zone zone{.name = "range", .kind = ocean::ZoneKind::no_go, .area = {}, .from = {}, .until = {}};
  zone.area.outer = {{-53.1, 60.0}, {-52.9, 60.0}, {-52.9, 75.0}, {-53.1, 75.0}};
  const ocean::Environment environment{.zones = {zone}};

  const auto found = plan(environment, eastward_request());

  ASSERT_FALSE(found.has_value());
  const Change* change = change_of(found.error(), "zones");
  ASSERT_NE(change, nullptr);
  EXPECT_EQ(std::get<std::string>(change->from), "range");
  EXPECT_EQ(std::get<std::string>(change->to), "none");
}

TEST(Relaxation, NamesBothSpacingsWhereBothWereAskedFor) {
  PlanRequest request = eastward_request();
  request.spacing_along = core::Metres{8000.0};
  request.spacing_across = core::Metres{6000.0};
  const Trial finer = [](const PlanRequest& changed) {
    return changed.spacing_across->value < 4000.0 ? TrialOutcome::possible : TrialOutcome::impossible;
  };

  const FoundChanges found = find_changes({}, request, Infeasible{.binding = Constraint::depth}, finer, {});

  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_EQ((std::get<std::array<double, 2>>(found.changes.front().to)), (std::array{4000.0, 3000.0}));
}

TEST(Relaxation, RaisesTheSpeedOfTheDriveInUse) {
  PlanRequest request = eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  request.energy.thruster = ThrusterUse::on;
  const ocean::Environment environment{
      .currents =
          support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{-0.6}, {0.0}}; }, 72)};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  const Change* faster = change_of(found.error(), "vehicle/thruster/speed_m_s");
  ASSERT_NE(faster, nullptr);
  EXPECT_GT(std::get<double>(faster->to), 0.6);
  EXPECT_EQ(change_of(found.error(), "speed_m_s"), nullptr);
}

TEST(Relaxation, NamesTheThrusterThatIsLeftOff) {
  PlanRequest request = eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  request.energy.thruster = ThrusterUse::off;
  const ocean::Environment environment{
      .currents =
          support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{-0.42}, {0.0}}; }, 300)};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  ASSERT_NE(change_of(found.error(), "thruster"), nullptr);
  request.energy.thruster = ThrusterUse::automatic;
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesTheDepartureAndTheHoldThatATimedAreaLetsPass) {
  PlanRequest request = eastward_request();
  request.holds.longest = core::Seconds{0.0};
  request.zones = {
      {.name = "firing",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.01, 67.6}, {-52.99, 67.6}, {-52.99, 70.4}, {-53.01, 70.4}}, .holes = {}},
       .from = {},
       .until = request.depart + core::Seconds{80.0 * 3600.0}}};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  const Change* later = change_of(found.error(), "depart");
  ASSERT_NE(later, nullptr);
  PlanRequest changed = request;
  changed.depart = std::get<core::UtcTime>(later->to);
  EXPECT_TRUE(plan({}, changed).has_value());
  // The vehicle reaches the area after 16 hours.
  EXPECT_LE(changed.depart - request.depart, core::Seconds{65.0 * 3600.0});
  ASSERT_NE(change_of(found.error(), "max_loiter_s"), nullptr);
}

TEST(Relaxation, NamesADepartureAfterAGapInTheCurrents) {
  const ocean::Environment environment{.currents = currents_from(
                                           [](geo::LonLat, double hour) {
                                             const bool is_missing = hour > 6.0 && hour < 14.0;
                                             return geo::VelocityEn{{is_missing ? NAN : 0.02}, {0.0}};
                                           },
                                           120)};
  const PlanRequest request = eastward_request();

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::data_area) << found.error().explanation();
  EXPECT_NE(change_of(found.error(), "depart"), nullptr);
}

TEST(Relaxation, NamesForAWantedArrivalOnlyWhatBringsTheVehicleThereInTime) {
  const ocean::Environment environment = headwind_until(1000.0);
  PlanRequest request = eastward_request();
  request.departures.arrive_by = request.depart + core::Seconds{3600.0 * 40.0};
  const auto found = plan_arrival(environment, request, {}, {});
  ASSERT_FALSE(found.has_value());

  const Change* faster = change_of(found.error(), "speed_m_s");

  ASSERT_NE(faster, nullptr);
  request.vehicle.speed_through_water = {std::get<double>(faster->to)};
  const auto in_time = plan_arrival(environment, request, {}, {});
  ASSERT_TRUE(in_time.has_value()) << in_time.error().explanation();
  EXPECT_LE(in_time->arrival, *request.departures.arrive_by);
  request.vehicle.speed_through_water = {std::get<double>(faster->to) - 0.05};
  EXPECT_FALSE(plan_arrival(environment, request, {}, {}).has_value());
}

TEST(Relaxation, NamesWhatMakesADepartureOfAWindowPossible) {
  const ocean::Environment environment = headwind_until(1000.0);
  PlanRequest request = eastward_request();
  request.departures.until = request.depart + core::Seconds{3600.0 * 3.0};
  request.departures.step = core::Seconds{3600.0};
  const WindowPlan found = plan_window(environment, request, {}, {});
  ASSERT_FALSE(found.plan.has_value());

  const Change* faster = change_of(found.plan.error(), "speed_m_s");

  ASSERT_NE(faster, nullptr);
  EXPECT_EQ(change_of(found.plan.error(), "depart"), nullptr);
  request.vehicle.speed_through_water = {std::get<double>(faster->to)};
  EXPECT_TRUE(plan_window(environment, request, {}, {}).plan.has_value());
}

TEST(Relaxation, NamesDivesAboveAnAreaWhereShallowerOnesAreCarriedAway) {
  // A current against the route: 0.5 m/s near the surface, nearly zero in the mean down to 60 m.
  const ocean::Environment environment{.currents = support::sheared_currents(), .steady_currents = true};
  PlanRequest request = eastward_request();
  std::swap(request.from, request.to);
  request.zones = {zone_across("trawlers", -53.0)};
  request.zones[0].top = core::Metres{60.0};
  for (geo::LonLat& corner : request.zones[0].area.outer)
    corner.lat_deg += corner.lat_deg > 69.0 ? 1.0 : -1.0;

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  const Change* shallower = change_of(found.error(), "dive_depth_m");
  ASSERT_NE(shallower, nullptr);
  EXPECT_EQ(std::get<double>(shallower->to), 59.0);
  request.vehicle.dive_depth = {59.0};
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesTheDepthOfDivesThatIsAllowed) {
  PlanRequest request = eastward_request();
  request.zones = {
      {.name = "upper water",
       .kind = ocean::ZoneKind::stay_in,
       .area = {.outer = {{-55.0, 68.0}, {-51.0, 68.0}, {-51.0, 70.0}, {-55.0, 70.0}}, .holes = {}},
       .from = {},
       .until = {},
       .bottom = core::Metres{90.0}}};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  const Change* shallower = change_of(found.error(), "dive_depth_m");
  ASSERT_NE(shallower, nullptr);
  request.vehicle.dive_depth = {std::get<double>(shallower->to)};
  EXPECT_TRUE(plan({}, request).has_value());
  request.vehicle.dive_depth.value += 5.0;
  EXPECT_FALSE(plan({}, request).has_value());
}

TEST(Relaxation, NamesWhatIsKeptAboveTheSeaBedWhereItIsMoreThanUsual) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat) { return 60.0; })};
  PlanRequest request = eastward_request();
  request.vehicle.altimeter_margin = core::Metres{70.0};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  const Change* less = change_of(found.error(), "altimeter_margin_m");
  ASSERT_NE(less, nullptr);
  request.vehicle.altimeter_margin = {std::get<double>(less->to)};
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesTheWorkingDepthThatTheWaterAllowsWhereItIsMoreThanUsual) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat) { return 150.0; })};
  PlanRequest request = eastward_request();
  request.vehicle.minimum_working_depth = core::Metres{180.0};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::depth);
  const Change* less = change_of(found.error(), "vehicle/minimum_working_depth_m");
  ASSERT_NE(less, nullptr);
  EXPECT_GT(std::get<double>(less->to), 140.0) << "not much less than the water allows";
  request.vehicle.minimum_working_depth = {std::get<double>(less->to)};
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesHowHighToClimbWhereDivesTurnTooDeepForTheWater) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat) { return 60.0; })};
  PlanRequest request = eastward_request();
  request.vehicle.climb_to = core::Metres{55.0};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  const Change* higher = change_of(found.error(), "climb_to_m");
  ASSERT_NE(higher, nullptr);
  request.vehicle.climb_to = {std::get<double>(higher->to)};
  EXPECT_TRUE(plan(environment, request).has_value());
  request.vehicle.climb_to.value += 5.0;
  EXPECT_FALSE(plan(environment, request).has_value());
}

/// The refusal comes from a rule that trials of single plans do not cover.
TEST(Relaxation, NamesNoChangeOfARequestThatHasASinglePlan) {
  PlanRequest request = eastward_request();
  request.zones = {{.name = "out of the way",
                    .area = {{{-53.1, 69.2}, {-52.9, 69.2}, {-52.9, 69.25}}, {}},
                    .from = std::nullopt,
                    .until = std::nullopt}};
  request.spacing_along = core::Metres{1500.0};
  ASSERT_TRUE(plan({}, request).has_value());
  Infeasible refusal;
  refusal.reason = Reason::goal_unreachable;
  refusal.binding = Constraint::zone;

  const Infeasible why = with_what_would_help({}, request, refusal, {}, {});

  EXPECT_TRUE(why.changes.empty());
}

TEST(Relaxation, TellsTheCauseBeforeItLooksForWhatWouldHelp) {
  Infeasible refusal;
  refusal.reason = Reason::goal_unreachable;
  refusal.why.text = "an area closes every route";
  std::vector<std::string> stages;

  (void)with_what_would_help({}, eastward_request(), refusal, {},
                             [&](std::string_view stage, double) { stages.emplace_back(stage); });

  ASSERT_FALSE(stages.empty());
  EXPECT_EQ(stages.front(), "not possible as asked: an area closes every route");
}

TEST(Relaxation, DivesNoLessDeepForAreasThatAreClosedAtAllDepths) {
  PlanRequest request = eastward_request();
  const geo::LonLat goal = request.to;
  request.zones = {{.name = "all depths",
                    .area = {{{goal.lon_deg - 0.1, 68.9},
                              {goal.lon_deg - 0.05, 68.9},
                              {goal.lon_deg - 0.05, 69.1},
                              {goal.lon_deg + 0.1, 69.1},
                              {goal.lon_deg + 0.1, 68.9}},
                             {}},
                    .from = std::nullopt,
                    .until = std::nullopt}};
  int dives_tried = 0;
  const Trial trial = [&](const PlanRequest& changed) {
    dives_tried += changed.vehicle.dive_depth == request.vehicle.dive_depth ? 0 : 1;
    return TrialOutcome::impossible;
  };
  Infeasible why;
  why.binding = Constraint::zone;

  const FoundChanges found = find_changes({}, request, why, trial, {});

  EXPECT_TRUE(found.changes.empty());
  EXPECT_EQ(dives_tried, 0);
}

TEST(Relaxation, DepartsWhenTheStartHasOpened) {
  PlanRequest request = eastward_request();
  request.zones = {
      {.name = "exercise",
       .kind = ocean::ZoneKind::no_go,
       .area = {.outer = {{-53.6, 68.95}, {-53.4, 68.95}, {-53.4, 69.05}, {-53.6, 69.05}}, .holes = {}},
       .from = {},
       .until = request.depart + core::Seconds{2.5 * 3600.0}}};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_NE(found.error().explanation().find("until"), std::string::npos) << found.error().explanation();
  const Change* later = change_of(found.error(), "depart");
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(std::get<core::UtcTime>(later->to), request.depart + core::Seconds{3.0 * 3600.0});
}

/// A wall of land from north to south with a gap of 0.1 degrees of latitude on the straight route.
std::shared_ptr<const ocean::Bathymetry> wall_with_a_gap() {
  return bathymetry_from([](geo::LonLat p) {
    return std::abs(p.lon_deg + 53.0) < 0.15 && std::abs(p.lat_deg - 69.0) > 0.03 ? -5.0 : 300.0;
  });
}

TEST(Relaxation, NamesTheIcebergThatClosesAGapInLand) {
  ocean::Environment environment{.bathymetry = wall_with_a_gap()};
  PlanRequest request = eastward_request();
  request.icebergs.drift = false;
  ASSERT_TRUE(plan(environment, request).has_value());
  environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 200.0)};
  // The place nearest to the goal lies beside the iceberg, or so far away that only land surrounds it.
  for (const double margin_m : {6000.0, 8000.0, 15'000.0}) {
    request.icebergs.margin = core::Metres{margin_m};

    const auto found = plan(environment, request);

    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().binding, Constraint::iceberg) << margin_m << found.error().explanation();
    const Change* margin = change_of(found.error(), "margin_m");
    ASSERT_NE(margin, nullptr) << margin_m;
    PlanRequest changed = request;
    changed.icebergs.margin = core::Metres{std::get<double>(margin->to)};
    EXPECT_TRUE(plan(environment, changed).has_value());
  }
}

TEST(Relaxation, NamesTheCurrentThroughAGapInLand) {
  const ocean::Environment environment{.currents = currents_from(
                                           [](geo::LonLat p, double) {
                                             return geo::VelocityEn{
                                                 {std::abs(p.lon_deg + 53.0) < 0.15 ? -0.6 : 0.0}, {0.0}};
                                           },
                                           120),
                                       .bathymetry = wall_with_a_gap()};
  PlanRequest request = eastward_request();
  Infeasible refusal;
  refusal.reason = Reason::goal_unreachable;
  refusal.binding = Constraint::land;

  const Infeasible why = with_what_would_help(environment, request, refusal, {}, {});

  EXPECT_EQ(why.binding, Constraint::current);
  const Change* faster = change_of(why, "speed_m_s");
  ASSERT_NE(faster, nullptr);
  request.vehicle.speed_through_water = {std::get<double>(faster->to)};
  EXPECT_TRUE(plan(environment, request).has_value());
}

TEST(Relaxation, NamesTheVehicleForShallowerWaterOfTheSameMake) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat p) {
                                         return std::abs(p.lon_deg + 53.0) < 0.15 ? 18.0 : 300.0;
                                       })};
  for (const char* name : {"slocum-g3-200", "slocum-g2-1000-thruster"}) {
    PlanRequest request = eastward_request();
    request.vehicle = vehicle::find_profile(name).value();
    request.flight.speed_through_water = core::MetresPerSecond{0.4};
    request.vehicle.speed_through_water = *request.flight.speed_through_water;

    const auto found = plan(environment, request);

    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().binding, Constraint::depth);
    const Change* other = change_of(found.error(), "vehicle");
    ASSERT_NE(other, nullptr) << name;
    EXPECT_EQ(std::get<std::string>(other->from), name);
    const auto profile = vehicle::find_profile(std::get<std::string>(other->to));
    ASSERT_TRUE(profile.has_value());
    EXPECT_EQ(profile->depth_rating.value, 30.0);
    EXPECT_EQ(profile->thruster.has_value(), request.vehicle.thruster.has_value());
    PlanRequest changed = request;
    changed.vehicle = vehicle::with_choices(*profile, request.flight);
    EXPECT_TRUE(plan(environment, changed).has_value());
  }
}

TEST(Relaxation, NamesNoVehicleThatCannotFlyAsIsAskedForWhateverItIs) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat p) {
                                         return std::abs(p.lon_deg + 53.0) < 0.15 ? 18.0 : 300.0;
                                       })};
  PlanRequest request = eastward_request();
  request.flight.dive_depth = request.vehicle.dive_depth;  // deeper than the other one is rated for

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(change_of(found.error(), "vehicle"), nullptr);
}

TEST(Relaxation, NamesTheSpeedThatPassesAnAreaBeforeItCloses) {
  PlanRequest request = eastward_request();
  request.zones = {zone_across("closes", -53.0)};
  request.zones.front().from = request.depart + core::Seconds{10.0 * 3600.0};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::zone);
  EXPECT_NE(change_of(found.error(), "areas/features/0"), nullptr);
  const Change* faster = change_of(found.error(), "speed_m_s");
  ASSERT_NE(faster, nullptr);
  request.vehicle.speed_through_water = {std::get<double>(faster->to)};
  EXPECT_TRUE(plan({}, request).has_value());
  request.vehicle.speed_through_water.value -= 0.05;
  EXPECT_FALSE(plan({}, request).has_value()) << "not much more than enough";
}

TEST(Relaxation, TriesNoSpeedWhereNoAreaEverCloses) {
  PlanRequest request = eastward_request();
  request.zones = {zone_across("closed", -53.0)};
  int speeds_tried = 0;
  const Trial trial = [&](const PlanRequest& changed) {
    speeds_tried += changed.vehicle.speed_through_water == request.vehicle.speed_through_water ? 0 : 1;
    return TrialOutcome::impossible;
  };

  const FoundChanges found = find_changes({}, request, Infeasible{.binding = Constraint::zone}, trial, {});

  EXPECT_TRUE(found.changes.empty());
  EXPECT_EQ(speeds_tried, 0);
}

TEST(Relaxation, LeavesOutAllAreasWhereNoneIsInTheWayAlone) {
  PlanRequest request = eastward_request();
  request.zones = {zone_across("west", -53.1), zone_across("east", -52.9)};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  ASSERT_EQ(found.error().changes.size(), 1U);
  const Change& change = found.error().changes.front();
  EXPECT_EQ(change.input, "areas");
  EXPECT_EQ(std::get<std::string>(change.from), "2 areas");
  EXPECT_TRUE(std::holds_alternative<Change::Nothing>(change.to));
  request.zones.clear();
  EXPECT_TRUE(plan({}, request).has_value());
}

/// A request and its environment after a change.
struct Asked {
  ocean::Environment environment;
  PlanRequest request;

  void apply(const Change& change) {
    for (const Change& other : change.with) apply(other);
    const auto number = [&] { return std::get<double>(change.to); };
    if (change.input == "speed_m_s") {
      request.vehicle.speed_through_water = {number()};
    } else if (change.input == "margin_m") {
      request.icebergs.margin = {number()};
    } else if (change.input == "max_loiter_s") {
      request.holds.longest = core::Seconds{number()};
    } else if (change.input == "spacing_m") {
      request.spacing_along = core::Metres{number()};
    } else if (change.input == "depart") {
      request.depart = std::get<core::UtcTime>(change.to);
    } else if (change.input == "vehicle") {
      const auto profile = vehicle::find_profile(std::get<std::string>(change.to));
      request.vehicle = vehicle::with_choices(profile.value(), request.flight);
    } else if (change.input == "zones") {
      environment.zones.clear();
    } else if (change.input == "areas") {
      request.zones.clear();
    } else if (change.input.starts_with("areas/features/")) {
      request.zones.erase(request.zones.begin() + std::stoi(change.input.substr(15)));
    } else {
      stop_named(request, change.input) = std::get<geo::LonLat>(change.to);
    }
  }
};

/// Random obstacles: land or a sill across the route, an iceberg, areas that are closed or will close; one or several.
Asked random_obstruction(std::mt19937_64& rng) {
  const auto one_of_two = [&] { return support::uniform_int(rng, 0, 1) == 1; };
  Asked asked{.environment = {}, .request = eastward_request()};
  if (one_of_two()) {
    asked.environment.bathymetry = wall_with_a_gap();
  } else if (one_of_two()) {
    asked.environment.bathymetry =
        bathymetry_from([](geo::LonLat p) { return std::abs(p.lon_deg + 53.0) < 0.15 ? 18.0 : 300.0; });
  }
  if (one_of_two()) {
    asked.environment.icebergs = {support::iceberg_at({-53.0, 69.0}, 200.0)};
    asked.request.icebergs.drift = false;
    asked.request.icebergs.margin = {support::uniform(rng, 1000.0, 15'000.0)};
  }
  for (int i = support::uniform_int(rng, 0, 2); i > 0; --i) {
    ocean::Zone zone = zone_across("area", -53.3 + 0.2 * i);
    if (one_of_two())
      zone.from = asked.request.depart + core::Seconds{3600.0 * support::uniform(rng, 2.0, 20.0)};
    if (one_of_two())
      zone.until = asked.request.depart + core::Seconds{3600.0 * support::uniform(rng, 21.0, 60.0)};
    (one_of_two() ? asked.request.zones : asked.environment.zones).push_back(zone);
  }
  return asked;
}

TEST(Relaxation, NamesNoChangeWithWhichThereIsNoPlan) {
  int named = 0;
  support::for_each_seed(40, [&](std::mt19937_64& rng) {
    const Asked asked = random_obstruction(rng);
    const auto found = plan(asked.environment, asked.request);
    if (found) return;

    for (const Change& change : found.error().changes) {
      Asked changed = asked;
      changed.apply(change);
      EXPECT_TRUE(plan(changed.environment, changed.request).has_value()) << change.text;
      ++named;
    }
  });
  EXPECT_GT(named, 5);
}

TEST(Relaxation, FindsNothingWhereNoInputHelps) {
  const ocean::Environment environment{.bathymetry = bathymetry_from([](geo::LonLat p) {
                                         return std::abs(p.lon_deg + 53.0) < 0.15 ? -5.0 : 300.0;
                                       })};

  const auto found = plan(environment, eastward_request());

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::land);
  EXPECT_TRUE(found.error().changes.empty());
}

TEST(Relaxation, LooksForNothingOnceItIsToStop) {
  std::stop_source source;
  source.request_stop();
  int trials = 0;
  const Trial count = [&](const PlanRequest&) {
    ++trials;
    return TrialOutcome::possible;
  };

  EXPECT_TRUE(find_changes({}, eastward_request(), Infeasible{.binding = Constraint::iceberg}, count,
                           source.get_token())
                  .changes.empty());
  EXPECT_EQ(trials, 0);
}

TEST(Relaxation, ClosesInOnTheSmallestChangeAlthoughSomeTrialsTellNothing) {
  const Trial fast_enough = [&](const PlanRequest& changed) {
    const double speed_m_s = changed.vehicle.speed_through_water.value;
    if (speed_m_s > 2.0 || speed_m_s < 0.4) return TrialOutcome::not_known;
    return speed_m_s >= 0.5 ? TrialOutcome::possible : TrialOutcome::impossible;
  };

  const FoundChanges found =
      find_changes({}, eastward_request(), Infeasible{.binding = Constraint::data_period}, fast_enough, {});

  EXPECT_TRUE(found.cut_short) << "a smaller one may help, too";
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_EQ(found.changes.front().input, "speed_m_s");
  EXPECT_NEAR(std::get<double>(found.changes.front().to), 0.5, 0.021);
}

TEST(Relaxation, TriesTheNextInputAfterOneWhoseTrialToldNothing) {
  const Trial by_error_only = [&](const PlanRequest& changed) {
    return changed.icebergs.max_inflation.value < 5000.0 ? TrialOutcome::possible : TrialOutcome::not_known;
  };

  const FoundChanges found =
      find_changes({}, eastward_request(), Infeasible{.binding = Constraint::iceberg}, by_error_only, {});

  EXPECT_TRUE(found.cut_short);
  ASSERT_EQ(found.changes.size(), 1U);
  EXPECT_EQ(found.changes.front().input, "max_inflation_m");
}

TEST(Relaxation, NamesABatteryOfAnySizeThatIsJustEnough) {
  PlanRequest request = eastward_request();
  request.to = {request.from.lon_deg + 0.1, request.from.lat_deg};  // 4 km
  vehicle::EnergyModel& energy = request.vehicle.energy;
  energy.battery_reserve_share = 0.0;
  const double needed_j = plan({}, request).value().energy->use.total().value;
  energy.battery = core::Joules{0.5 * needed_j};
  request.energy.require_battery = true;

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  const Change* change = change_of(found.error(), "battery_j");
  ASSERT_NE(change, nullptr);
  EXPECT_GE(std::get<double>(change->to), needed_j);
  EXPECT_LE(std::get<double>(change->to), 1.05 * needed_j);
}

TEST(Relaxation, NamesTheBatteryThatIsJustEnough) {
  PlanRequest request = eastward_request();
  vehicle::EnergyModel& energy = request.vehicle.energy;
  energy.battery_reserve_share = 0.0;
  energy.battery_start_share = 0.5;
  energy.battery = 1.6 * plan({}, request).value().energy->use.total();
  request.energy.require_battery = true;

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().binding, Constraint::battery);
  for (const char* input : {"battery_start_share", "battery_j"}) {
    const Change* change = change_of(found.error(), input);
    ASSERT_NE(change, nullptr) << input;
    const auto with = [&](double value) {
      PlanRequest changed = request;
      vehicle::EnergyModel& other = changed.vehicle.energy;
      (change->input == "battery_j" ? other.battery.value : other.battery_start_share) = value;
      return plan({}, changed).has_value();
    };
    const auto needed = std::get<double>(change->to);
    EXPECT_TRUE(with(needed)) << input << ": the change that is named is enough";
    EXPECT_FALSE(with(0.9 * needed)) << input << ": and not much more than enough";
  }
}

TEST(Relaxation, NamesTheThrusterThatDrawsTooMuch) {
  PlanRequest request = eastward_request();
  request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  request.vehicle.energy.battery_reserve_share = 0.0;
  request.energy.require_battery = true;
  const auto by_thruster = plan({}, request);
  ASSERT_TRUE(by_thruster.has_value());
  request.vehicle.energy.battery = {0.7 * by_thruster->energy->use.total().value};

  const auto found = plan({}, request);

  ASSERT_FALSE(found.has_value());
  const Change* off = change_of(found.error(), "thruster");
  ASSERT_NE(off, nullptr);
  EXPECT_EQ(std::get<std::string>(off->to), "off");
}

TEST(Relaxation, TriesNoOtherHourWhereThereAreNoDataAtTheStart) {
  ocean::Environment environment = headwind_until(1000.0);
  environment.bathymetry = bathymetry_from([](geo::LonLat) { return 500.0; });
  PlanRequest request = eastward_request();
  request.from = {-56.4, 69.0};

  const auto found = plan(environment, request);

  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().reason, Reason::outside_data);
  EXPECT_TRUE(found.error().at_a_stop);
  int trials = 0;
  const Trial count = [&](const PlanRequest&) {
    ++trials;
    return TrialOutcome::impossible;
  };
  EXPECT_TRUE(find_changes(environment, request, found.error(), count, {}, {}).changes.empty());
  EXPECT_EQ(trials, 0);
}

}  // namespace
}  // namespace floeplan::planning::diagnosis::relaxation_test
