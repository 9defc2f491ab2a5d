#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "engine/planning/planner/departure.hpp"
#include "engine/planning/search/latest_departure.hpp"
#include "tests/engine/planning/drifting_bergs.hpp"

/// Every route of making a plan keeps every rule of the request. The water is still, so that a plan's vehicle moves
/// evenly from waypoint to waypoint and can be followed here without the planner.
namespace floeplan::planning::plan_rules_test {
namespace {

using core::Metres;
using core::Seconds;
using ocean::Environment;
using ocean::ZoneKind;

geo::Polygon box(double west, double south, double east, double north) {
  return {.outer = {{west, south}, {east, south}, {east, north}, {west, north}}, .holes = {}};
}

struct Passage {
  geo::LonLat place;
  core::UtcTime time;
};

/// The place of the plan's vehicle at a hundred times on each leg.
std::vector<Passage> follow(const Plan& plan) {
  std::vector<Passage> passages;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const Waypoint& a = plan.waypoints[i - 1];
    const Waypoint& b = plan.waypoints[i];
    const core::UtcTime leaves = a.eta + a.wait;
    for (int k = 0; k <= 100; ++k) {
      const double share = k / 100.0;
      passages.push_back({{a.place.lon_deg + share * (b.place.lon_deg - a.place.lon_deg),
                           a.place.lat_deg + share * (b.place.lat_deg - a.place.lat_deg)},
                          leaves + share * (b.eta - leaves)});
    }
  }
  return passages;
}

/// A route of making a plan: what it asks for, and how it is asked.
struct Way {
  std::string name;
  std::function<void(PlanRequest&, Environment&)> ask;
  std::function<Result<Plan>(const Environment&, const PlanRequest&)> make =
      [](const Environment& environment, const PlanRequest& request) {
        return plan_route(environment, request, {}, {});
      };
};

const Seconds quarter_of_a_day{6.0 * hour_s};

/// Evaluates the plan's route again, as a pilot's copy of it would be.
Result<Plan> plan_and_judge(const Environment& environment, const PlanRequest& request) {
  const Result<Plan> plan = plan_route(environment, request, {}, {});
  if (!plan) return plan;
  std::vector<geo::LonLat> route;
  for (const Waypoint& waypoint : plan->waypoints) route.push_back(waypoint.place);
  return evaluate_route(environment, route, request);
}

std::vector<Way> ways() {
  const auto use_thruster = [](PlanRequest& request) {
    request.vehicle = vehicle::find_profile("slocum-g3-200-thruster").value();
  };
  const auto with_members = [](PlanRequest& request, Environment& environment) {
    environment.currents = support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{}; }, 240);
    environment.members = {environment.currents, environment.currents};
    request.uncertainty.objective = RobustObjective::mean;
  };
  return {
      {"fastest", [](PlanRequest&, Environment&) {}},
      {"dijkstra", [](PlanRequest& r, Environment&) { r.method = Method::dijkstra; }},
      {"label correcting", [](PlanRequest& r, Environment&) { r.method = Method::tve; }},
      {"straight", [](PlanRequest& r, Environment&) { r.method = Method::direct; }},
      {"not refined", [](PlanRequest& r, Environment&) { r.refine = false; }},
      {"by energy", [](PlanRequest& r, Environment&) { r.energy.objective = energy_objective; }},
      {"by energy with a thruster",
       [=](PlanRequest& r, Environment&) {
         use_thruster(r);
         r.energy.objective = {1.0, 0.05};
       }},
      {"with few encounters",
       [](PlanRequest& r, Environment&) { r.icebergs.encounter_weight = Seconds{1e5}; }},
      {"for an ensemble", with_members},
      {"for an ensemble by energy",
       [=](PlanRequest& r, Environment& e) {
         with_members(r, e);
         r.energy.objective = energy_objective;
       }},
      {"with waits", [](PlanRequest& r, Environment&) { r.holds.longest = quarter_of_a_day; }},
      {"below icebergs", [](PlanRequest& r, Environment&) { r.icebergs.pass_under = true; }},
      {"past a place", [](PlanRequest& r, Environment&) { r.via = {{-53.3, 69.05}}; }},
      {"past places in the best order",
       [](PlanRequest& r, Environment&) {
         r.via = {{-52.7, 69.05}, {-53.3, 69.05}};
         r.via_in_best_order = true;
       }},
      {"in a window",
       [](PlanRequest& r, Environment&) {
         r.departures.until = r.depart + quarter_of_a_day;
         r.departures.step = 0.5 * quarter_of_a_day;
       },
       [](const Environment& e, const PlanRequest& r) { return plan_window(e, r, {}, {}).plan; }},
      {"judged as a route", [](PlanRequest&, Environment&) {}, plan_and_judge},
      {"judged as a route with a thruster",
       [=](PlanRequest& r, Environment&) {
         use_thruster(r);
         r.energy.objective = {1.0, 0.05};
       },
       plan_and_judge},
      {"to arrive in time",
       [](PlanRequest& r, Environment&) { r.departures.arrive_by = r.depart + Seconds{60.0 * hour_s}; },
       [](const Environment& e, const PlanRequest& r) { return plan_arrival(e, r, {}, {}); }},
  };
}

/// A rule of the request, and what in a plan breaks it; empty: nothing.
struct Rule {
  std::string name;
  std::function<void(PlanRequest&, Environment&)> ask;
  std::function<std::string(const Plan&, const PlanRequest&, const Environment&)> fault_of;
};

std::string first_inside(const Plan& plan, const geo::Polygon& area,
                         const std::function<bool(core::UtcTime)>& is_closed) {
  for (const Passage& passage : follow(plan)) {
    if (is_closed(passage.time) && geo::contains(area, passage.place))
      return "at " + std::to_string(passage.place.lon_deg) + ", " + std::to_string(passage.place.lat_deg);
  }
  return "";
}

ocean::Zone zone(ZoneKind kind, const geo::Polygon& area) {
  return {.name = "area", .kind = kind, .area = area, .from = {}, .until = {}};
}

const geo::Polygon wall = box(-53.02, 68.95, -52.98, 69.07);
const geo::Polygon corridor = box(-53.6, 68.98, -52.4, 69.12);

/// Ice of 90 % in the middle of the route, open north of 69.12 N.
void add_ice(Environment& environment) {
  environment.ice = support::ice_from(
      [](geo::LonLat p, double) {
        return std::abs(p.lon_deg + 53.0) < 0.26 && p.lat_deg < 69.12 ? 0.9 : 0.0;
      },
      {0.0}, 1.0);
}

std::vector<Rule> rules() {
  const auto always = [](core::UtcTime) { return true; };
  const auto by_day = [](core::UtcTime time) {
    return time > start + Seconds{10.0 * hour_s} &&
           time < start + Seconds{20.0 * hour_s - 1.0};  // who holds enters as it opens
  };
  return {
      {"an area to keep out of",
       [](PlanRequest& r, Environment&) { r.zones = {zone(ZoneKind::no_go, wall)}; },
       [=](const Plan& plan, const PlanRequest&, const Environment&) {
         return first_inside(plan, wall, always);
       }},
      {"an area to stay in",
       [](PlanRequest& r, Environment&) { r.zones = {zone(ZoneKind::stay_in, corridor)}; },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         const geo::Polygon with_border = box(-53.6, 68.9799, -52.4, 69.1201);
         const auto is_inside = [&](const Passage& at) { return geo::contains(with_border, at.place); };
         return std::ranges::all_of(follow(plan), is_inside) ? "" : "outside";
       }},
      {"an area that is closed for a while",
       [=](PlanRequest& r, Environment&) {
         ocean::Zone closed = zone(ZoneKind::no_go, wall);
         closed.from = start + Seconds{10.0 * hour_s};
         closed.until = start + Seconds{20.0 * hour_s};
         r.zones = {closed};
       },
       [=](const Plan& plan, const PlanRequest&, const Environment&) {
         return first_inside(plan, wall, by_day);
       }},
      {"shallow water",
       [](PlanRequest&, Environment& e) {
         e.bathymetry = support::bathymetry_from([](geo::LonLat p) {
           return geo::contains(box(-53.16, 68.7, -52.84, 69.06), p) ? 8.0 : p.lat_deg > 69.1 ? 90.0 : 300.0;
         });
       },
       [](const Plan& plan, const PlanRequest&, const Environment& e) -> std::string {
         for (const Passage& passage : follow(plan)) {
           if (e.bathymetry->depth(passage.place).value_or(Metres{0.0}) < Metres{20.0}) return "too shallow";
         }
         return "";
       }},
      {"icebergs",
       [](PlanRequest& r, Environment& e) {
         r.icebergs.max_inflation = Metres{1500.0};
         e.icebergs = {drifting_berg({-53.0, 69.02}, 300.0, 0.0, 0.0),
                       drifting_berg({-52.8, 68.98}, 200.0, 0.0, 0.0)};
       },
       [](const Plan& plan, const PlanRequest& r, const Environment& e) -> std::string {
         // So far north a constant course bends away from the straight line of the simulation's plane by some metres.
         const double gap_m = least_gap_m(plan, e, r.icebergs);
         return gap_m > -30.0 ? "" : "inside a disc by " + std::to_string(-gap_m) + " m";
       }},
      {"the longest time without a surfacing",
       [](PlanRequest& r, Environment& e) {
         add_ice(e);
         r.under_ice.max_time_without_surfacing = quarter_of_a_day;
       },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         Seconds longest{0.0};
         core::UtcTime surfaced = plan.departure;
         for (const Passage& at : follow(plan)) {
           const bool below = std::abs(at.place.lon_deg + 53.0) < 0.24 && at.place.lat_deg < 69.10;
           if (!below) surfaced = at.time;
           longest = std::max(longest, at.time - surfaced);
         }
         return longest <= quarter_of_a_day ? "" : std::to_string(longest.count() / hour_s) + " h";
       }},
      {"ways of escape",
       [](PlanRequest& r, Environment& e) {
         add_ice(e);
         r.under_ice.escape_plan = true;
       },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         return plan.surfacing && plan.surfacing->escapes.size() == plan.waypoints.size() ? "" : "none";
       }},
      {"planned surfacings",
       [](PlanRequest& r, Environment&) { r.under_ice.surfacing_interval = quarter_of_a_day; },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         return plan.surfacing && plan.surfacing->surfacings.size() + 1 >=
                                      static_cast<std::size_t>(plan.travel_time() / quarter_of_a_day)
                    ? ""
                    : "too few";
       }},
      {"the longest leg", [](PlanRequest& r, Environment&) { r.max_leg = Metres{9000.0}; },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         const auto is_long = [](const Waypoint& w) { return w.leg_length && w.leg_length->value > 9001.0; };
         return std::ranges::any_of(plan.waypoints, is_long) ? "a leg is longer" : "";
       }},
      {"the most waypoints",
       [](PlanRequest& r, Environment& e) {
         e.bathymetry = support::bathymetry_from(
             [](geo::LonLat p) { return geo::contains(box(-53.1, 68.7, -52.9, 69.06), p) ? 8.0 : 300.0; });
         r.max_waypoints = 6;
       },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         return plan.waypoints.size() <= 6 ? "" : std::to_string(plan.waypoints.size());
       }},
      {"what the battery gives",
       [](PlanRequest& r, Environment&) {
         r.vehicle.energy.battery = core::Joules{4e5};
         r.energy.require_battery = true;
       },
       [](const Plan& plan, const PlanRequest&, const Environment&) -> std::string {
         return plan.energy->use.total() <= plan.energy->usable ? "" : "drawn more";
       }},
      {"places to visit", [](PlanRequest& r, Environment&) { r.via.push_back({-52.9, 69.04}); },
       [](const Plan& plan, const PlanRequest& r, const Environment&) -> std::string {
         const auto is_visited = [&](geo::LonLat via) {
           return std::ranges::any_of(plan.waypoints, [&](const Waypoint& waypoint) {
             return geo::geodesic_between(waypoint.place, via).length.value < 1.0;
           });
         };
         return std::ranges::all_of(r.via, is_visited) ? "" : "not visited";
       }},
  };
}

class EveryWayOfPlanning : public testing::TestWithParam<std::size_t> {};

TEST_P(EveryWayOfPlanning, KeepsTheRule) {
  const Rule rule = rules()[GetParam()];
  std::size_t plans = 0;
  for (const Way& way : ways()) {
    Environment environment;
    // At some distance from the straight line pumping costs more, so that least energy and least time differ.
    environment.bathymetry =
        support::bathymetry_from([](geo::LonLat p) { return p.lat_deg > 69.1 ? 90.0 : 300.0; });
    PlanRequest request = support::eastward_request();
    request.spacing_along = Metres{2000.0};
    request.optimality_gap = false;
    way.ask(request, environment);
    rule.ask(request, environment);

    const Result<Plan> plan = way.make(environment, request);

    if (!plan) continue;
    ++plans;
    EXPECT_EQ(rule.fault_of(*plan, request, environment), "") << rule.name << ", " << way.name;
  }
  EXPECT_GE(plans, ways().size() - 3) << rule.name << ": hardly a rule where there is no plan";
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
  std::string name = rules()[info.param].name;
  std::ranges::replace(name, ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Rules, EveryWayOfPlanning, testing::Range<std::size_t>(0, rules().size()), name_of);

}  // namespace
}  // namespace floeplan::planning::plan_rules_test
