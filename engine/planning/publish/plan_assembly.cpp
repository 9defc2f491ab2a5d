#include "engine/planning/publish/plan_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "engine/core/shown_text.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "engine/planning/cost/met_currents.hpp"
#include "engine/planning/cost/surfacing.hpp"
#include "engine/planning/publish/land_distance.hpp"
#include "engine/planning/publish/route_moves.hpp"
#include "engine/planning/publish/route_samples.hpp"
#include "engine/planning/publish/warnings.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::publish {
namespace {

/// The iceberg whose hull, at its forecast place when the vehicle passes, the route comes nearest to, and how near.
void add_iceberg_clearance(Clearances& clearances, const cost::Sea& sea,
                           const std::vector<geo::PlanePoint>& route, const cost::Schedule& schedule,
                           const std::vector<vehicle::Drive>& drives) {
  if (sea.domain().icebergs().empty()) return;
  std::optional<obstacles::IcebergDiscs::NearestHull> least;
  for_each_move(sea, route, schedule, drives, [&](std::size_t, const motion::EvenMove& move) {
    const auto nearest = sea.domain().icebergs().nearest_hull(move);
    if (nearest && (!least || nearest->distance < least->distance)) least = nearest;
  });
  if (!least) return;
  clearances.iceberg = least->distance;
  clearances.nearest_iceberg = sea.domain().icebergs().name(least->berg);
}

/// Expected encounters with icebergs, for each leg and in total.
void add_iceberg_encounters(Plan& plan, const cost::Sea& sea, const std::vector<geo::PlanePoint>& route,
                            const cost::Schedule& schedule, const std::vector<vehicle::Drive>& drives) {
  if (sea.domain().icebergs().empty()) return;
  std::vector<double> of_leg(route.size(), 0.0);
  for_each_move(sea, route, schedule, drives, [&](std::size_t leg, const motion::EvenMove& move) {
    of_leg[leg] += sea.domain().icebergs().expected_encounters(move);
  });
  double all = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    plan.waypoints[i].iceberg_encounters = of_leg[i];
    all += of_leg[i];
  }
  plan.iceberg_encounters = all;
}

/// Where and when the vehicle is below icebergs. Two stays in one disc without a gap count as one.
void add_passages_under(Plan& plan, const cost::Sea& sea, const std::vector<geo::PlanePoint>& route,
                        const cost::Schedule& schedule, const std::vector<vehicle::Drive>& drives) {
  constexpr core::Seconds apart{1.0};
  constexpr std::size_t longest_name = 60;  // letters of a name in the message
  std::vector<obstacles::IcebergDiscs::Under> stays;
  for_each_move(sea, route, schedule, drives, [&](std::size_t, const motion::EvenMove& move) {
    for (const obstacles::IcebergDiscs::Under& stay : sea.domain().icebergs().passed_under(move)) {
      const auto goes_on = [&](const obstacles::IcebergDiscs::Under& other) {
        return other.berg == stay.berg && stay.span.from <= other.span.until + apart;
      };
      const auto known = std::ranges::find_if(stays, goes_on);
      if (known == stays.end()) {
        stays.push_back(stay);
      } else {
        known->span.until = std::max(known->span.until, stay.span.until);
      }
    }
  });
  for (const obstacles::IcebergDiscs::Under& stay : stays) {
    plan.passed_under.push_back({sea.domain().icebergs().name(stay.berg),
                                 sea.domain().icebergs().keel(stay.berg), plan.departure + stay.span.from,
                                 plan.departure + stay.span.until});
    const PassedUnder& passed = plan.passed_under.back();
    plan.messages.push_back(messages::plan_message<"passes-under-iceberg">(
        core::cut_short(passed.iceberg, longest_name), passed.from, passed.until,
        std::ceil(passed.keel.upper_turn.value)));
  }
}

std::optional<core::Metres> bottom_clearance(const cost::Sea& sea, const ocean::Environment& environment,
                                             const PlanRequest& request,
                                             const std::vector<geo::PlanePoint>& route) {
  if (!environment.bathymetry) return std::nullopt;
  std::optional<core::Metres> least;
  for_each_sample(route, [&](std::size_t, double, geo::PlanePoint point) {
    const auto bed = environment.bathymetry->shoalest(sea.domain().projection().to_lon_lat(point));
    if (!bed) return;
    const core::Metres deepest =
        std::min(request.vehicle.dive_depth, *bed - request.vehicle.altimeter_margin);
    const core::Metres left = *bed - deepest;
    if (!least || left < *least) least = left;
  });
  return least;
}

/// Names the icebergs whose sightings are too old for this departure, though not for an earlier one.
void warn_of_old_sightings(Plan& plan, const ocean::Environment& environment, const PlanRequest& request) {
  std::vector<std::string> names;
  bool can_count = false;  // with a larger age of sightings
  for (const ocean::Iceberg& iceberg : environment.icebergs) {
    if (!ocean::is_too_old(iceberg, request.depart)) continue;
    names.push_back(iceberg.id.empty() ? "one without a name" : iceberg.id);
    can_count = can_count ||
                request.depart < ocean::too_old_from(iceberg.observed, ocean::largest_sighting_age);
  }
  if (names.empty()) return;
  const std::string listed = core::shortened_list(names);
  const core::UtcTime then = request.depart;
  plan.messages.push_back(
      can_count ? messages::plan_message<"sightings-too-old-at-departure">(names.size(), then, listed)
                : messages::plan_message<"sightings-too-old-for-any-plan-then">(names.size(), then, listed));
}

/// Adds the energy of planned surfacings, unless the vehicle's energy model already includes regular
/// surfacings.
void add_energy_of_surfacings(Plan& plan, const PlanRequest& request) {
  if (request.vehicle.energy.surfacing_interval) return;
  for (const PlannedSurfacing& surfacing : plan.surfacing->surfacings) {
    plan.energy->use.hotel = plan.energy->use.hotel + request.vehicle.energy.surfacing;
    for (Waypoint& waypoint : plan.waypoints)
      if (waypoint.eta >= surfacing.time)
        waypoint.energy = *waypoint.energy + request.vehicle.energy.surfacing;
  }
}

/// For dives that turn deep below icebergs. The currents are means over the requested depths there: icebergs
/// are small and drift. Under sea ice the currents are means over the dives flown there.
void warn_of_deep_turns(Plan& plan, const PlanRequest& request) {
  core::Metres deepest{0.0};
  for (const PassedUnder& passed : plan.passed_under) deepest = std::max(deepest, passed.keel.upper_turn);
  if (deepest <= request.vehicle.climb_to) return;
  plan.messages.push_back(messages::plan_message<"currents-of-shallower-turns">(
      std::ceil(deepest.value), request.vehicle.climb_to.value));
}

/// Warns of ice beside the route below which the vehicle may come because of its position error.
void warn_of_ice_beside(Plan& plan, const PlanRequest& request) {
  const IceBeside& beside = plan.surfacing->ice_beside;
  core::Metres deepest = request.vehicle.climb_to;
  for (const SurfacingState& state : plan.surfacing->waypoints)
    deepest = std::max({deepest, state.least_upper_turn, state.leg_upper_turn.value_or(core::Metres{0.0})});
  if (std::ceil(beside.upper_turn.value) <= std::ceil(deepest.value)) return;
  const double turn_m = std::ceil(beside.upper_turn.value);
  const double least_dive_m = turn_m + vehicle::lowest_tooth.value;
  const double error_km = beside.error.value / 1000.0;
  const double planned_turn_m = std::ceil(deepest.value);
  const auto [lon_deg, lat_deg] = beside.place;
  const auto message = [&] {
    if (least_dive_m > request.vehicle.depth_rating.value) {
      return messages::plan_message<"ice-beside-too-deep">(error_km, lon_deg, lat_deg, turn_m,
                                                           planned_turn_m);
    }
    if (least_dive_m > request.vehicle.dive_depth.value) {
      return messages::plan_message<"ice-beside-needs-deeper-dives">(error_km, lon_deg, lat_deg, turn_m,
                                                                     planned_turn_m, least_dive_m);
    }
    return messages::plan_message<"ice-beside">(error_km, lon_deg, lat_deg, turn_m, planned_turn_m);
  };
  plan.messages.push_back(message().at(beside.place));
}

void warn_of_surfacings_near_ice(Plan& plan) {
  const auto is_near = [](const PlannedSurfacing& surfacing) { return surfacing.nearest_ice.has_value(); };
  const auto& surfacings = plan.surfacing->surfacings;
  const auto first = std::ranges::find_if(surfacings, is_near);
  if (first == surfacings.end()) return;
  plan.messages.push_back(messages::plan_message<"surfacings-near-ice">(
                              std::ranges::count_if(surfacings, is_near), surfacings.size(), first->time,
                              first->nearest_ice->value / 1000.0, first->position_error.value / 1000.0)
                              .at(first->place));
}

/// Warns of leads that the route needs to keep its limit on the time without surfacing and that the vehicle
/// may miss.
void warn_of_openings_missed(Plan& plan, const PlanRequest& request) {
  const auto& bound = request.under_ice.max_time_without_surfacing;
  const core::Seconds sure = plan.surfacing->longest_without_sure;
  if (!bound || sure <= std::max(*bound, plan.surfacing->longest_without)) return;
  plan.messages.push_back(
      messages::plan_message<"leads-may-be-missed">(bound->count() / 3600.0, sure.count() / 3600.0));
  plan.messages.back().place = plan.surfacing->missed_lead;
}

void add_surfacings(Plan& plan, const cost::Sea& sea, const PlanRequest& request,
                    const std::vector<geo::PlanePoint>& route, const cost::Schedule& schedule,
                    const std::vector<vehicle::Drive>& drives) {
  const UnderIceRules& rules = request.under_ice;
  const bool asked = rules.max_time_without_surfacing || rules.surfacing_interval || rules.escape_plan;
  if (!sea.domain().ice() && !asked && plan.passed_under.empty()) return;
  plan.surfacing = cost::plan_surfacings(sea, request, route, schedule, drives);
  if (plan.surfacing->unknown_ice.value > 0.0) {
    plan.messages.push_back(
        messages::plan_message<"ice-unknown-on-route">(plan.surfacing->unknown_ice.value / 1000.0));
  }
  add_energy_of_surfacings(plan, request);
  warn_of_deep_turns(plan, request);
  warn_of_ice_beside(plan, request);
  warn_of_surfacings_near_ice(plan);
  warn_of_openings_missed(plan, request);
  tell_of_ice_above(plan, request);
}

}  // namespace

Plan assemble_plan(const cost::Sea& sea, const ocean::Environment& environment, const PlanRequest& request,
                   const std::vector<geo::PlanePoint>& route, const cost::Schedule& schedule,
                   const std::vector<vehicle::Drive>& drives, const std::stop_token& stop) {
  const std::vector<core::Seconds>& arrivals = schedule.arrivals;
  Plan plan;
  plan.method = request.method;
  plan.vehicle = request.vehicle.name;
  plan.departure = request.depart;
  plan.arrival = request.depart + arrivals.back();
  const auto currents = cost::leg_currents(sea, route, schedule, drives);
  EnergyUse drawn;
  for (std::size_t i = 0; i < route.size(); ++i) {
    Waypoint waypoint;
    waypoint.place = sea.domain().projection().to_lon_lat(route[i]);
    waypoint.eta = request.depart + arrivals[i];
    waypoint.current = currents[i];
    if (environment.bathymetry) waypoint.depth = environment.bathymetry->depth(waypoint.place);
    if (i > 0) {
      const geo::GeodesicLine leg = geo::geodesic_between(plan.waypoints.back().place, waypoint.place);
      waypoint.leg_length = leg.length;
      waypoint.course_deg = leg.course_at_start.degrees();
      const core::Seconds duration = arrivals[i] - schedule.leaves(i - 1);
      waypoint.speed_over_ground = core::MetresPerSecond{leg.length.value / duration.count()};
      plan.distance = plan.distance + leg.length;
      drawn += sea.energy_along(route[i - 1], route[i], schedule.leaves(i - 1), duration, drives[i - 1]);
      waypoint.drive = drives[i - 1];
      waypoint.speed_through_water = sea.speed(drives[i - 1]);
    }
    waypoint.energy = drawn.total();
    if (schedule.waits[i].count() > 0.0) {
      waypoint.wait = schedule.waits[i];
      drawn += sea.energy_along(route[i], route[i], arrivals[i], waypoint.wait, drives[i]);
    }
    plan.waypoints.push_back(waypoint);
  }
  add_iceberg_clearance(plan.clearances, sea, route, schedule, drives);
  add_iceberg_encounters(plan, sea, route, schedule, drives);
  plan.energy = PlanEnergy{.use = drawn, .usable = request.vehicle.energy.usable()};
  plan.clearances.bottom = bottom_clearance(sea, environment, request, route);
  plan.clearances.land = land_clearance(sea, environment, route);
  plan.optimality_gap_reason = "not asked for";
  if (sea.domain().currents()) plan.strongest_current = sea.domain().currents()->strongest();
  plan.datasets = environment.datasets;
  plan.messages = messages_beside_drift(environment);
  warn_of_old_sightings(plan, environment, request);
  std::ranges::move(drift_warnings(sea, environment, request, route, schedule, drives, stop),
                    std::back_inserter(plan.messages));
  std::ranges::move(water_warnings(sea, environment, request, route, schedule, drives),
                    std::back_inserter(plan.messages));
  if (auto message = zone_warning(sea, request, route, schedule, drives))
    plan.messages.push_back(*std::move(message));
  add_passages_under(plan, sea, route, schedule, drives);
  add_surfacings(plan, sea, request, route, schedule, drives);
  if (auto message = land_warning(plan, sea, environment, request, route, schedule))
    plan.messages.push_back(*std::move(message));
  return plan;
}

}  // namespace floeplan::planning::publish
