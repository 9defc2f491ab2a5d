#include "engine/mission/checking/route_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::mission {
namespace {

constexpr int most_findings = 20;
constexpr double same_place_m = 1.0;   // shorter legs do not count for the planner
constexpr double longest_leg_m = 5e6;  // the planner takes no longer ones
constexpr double sample_step_m = 250.0;

using planning::Infeasible;
using planning::Reason;

double length_m(geo::LonLat a, geo::LonLat b) { return geo::geodesic_between(a, b).length.value; }

/// The part of the route that is not checked yet, without places that repeat the one before.
struct Rest {
  std::vector<std::size_t> places;  // indices into the route
  core::UtcTime depart;
};

Rest whole_of(const std::vector<geo::LonLat>& route, core::UtcTime depart) {
  Rest rest{{}, depart};
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (!geo::is_valid(route[i])) throw std::invalid_argument{"check_route: a place off the Earth"};
    if (rest.places.empty() || length_m(route[rest.places.back()], route[i]) > same_place_m)
      rest.places.push_back(i);
  }
  return rest;
}

bool concerns_start(Reason reason) {
  return reason == Reason::start_on_land || reason == Reason::start_too_shallow ||
         reason == Reason::start_near_iceberg || reason == Reason::start_in_zone;
}

bool concerns_goal(Reason reason) {
  return reason == Reason::goal_on_land || reason == Reason::goal_too_shallow ||
         reason == Reason::goal_near_iceberg || reason == Reason::goal_in_zone;
}

/// Unknown conditions alone are no danger.
bool is_dangerous(Reason reason) {
  return reason != Reason::outside_data && reason != Reason::too_large && reason != Reason::cancelled;
}

/// The leg on which a place lies: the one to which it adds the smallest detour.
std::size_t leg_at(const std::vector<geo::LonLat>& places, geo::LonLat at) {
  std::size_t nearest = 1;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double detour_m =
        length_m(places[i - 1], at) + length_m(at, places[i]) - length_m(places[i - 1], places[i]);
    if (detour_m >= least_m - 0.5) continue;
    least_m = detour_m;
    nearest = i;
  }
  return nearest;
}

RouteFinding finding_of(const Infeasible& closed, std::size_t place) {
  std::array<char, 80> where{};
  std::snprintf(where.data(), where.size(), "%.4f, %.4f", closed.at.lon_deg, closed.at.lat_deg);
  const bool dangerous = is_dangerous(closed.reason);
  const messages::Message told =
      dangerous
          ? messages::mission_check_message<"leg_closed">(closed.explanation(), where.data(), closed.when)
          : messages::mission_check_message<"leg_unknown">(closed.explanation(), where.data(), closed.when);
  return {place, dangerous, planning::reason_name(closed.reason), messages::whole_text(told)};
}

/// A dangerous finding with the text of a message of the catalogue.
RouteFinding danger(std::size_t place, const messages::Message& told) {
  return {place, true, told.code, messages::whole_text(told)};
}

/// The fault of the dives on the leg to `place`, over its shoalest bed; empty: none.
std::optional<RouteFinding> finding_of(const DiveArguments& dive, core::Metres bed, std::size_t place) {
  if (!dive.altimeter && bed <= dive.target_depth)
    return danger(place,
                  messages::mission_check_message<"bottom_above_target">(dive.target_depth.value, bed.value));
  const bool on_land = bed.value <= 0.0;  // check_route reports land
  if (on_land || bed >= dive.climb_to + vehicle::lowest_tooth + dive.altitude) return std::nullopt;
  return danger(place, messages::mission_check_message<"bottom_above_climb">(dive.climb_to.value,
                                                                             dive.altitude.value, bed.value));
}

}  // namespace

RouteCheck check_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                       const planning::PlanRequest& request) {
  RouteCheck check;
  Rest rest = whole_of(route, request.depart);
  const double speed_m_s = request.vehicle.speed_through_water.value;
  const auto spend = [&](double distance_m) { return core::Seconds{distance_m / speed_m_s}; };

  while (rest.places.size() >= 2 && check.findings.size() < most_findings) {
    std::vector<geo::LonLat> places;
    places.reserve(rest.places.size());
    for (const std::size_t place : rest.places) places.push_back(route[place]);
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (length_m(places[i - 1], places[i]) <= longest_leg_m) continue;
      check.findings.push_back(danger(rest.places[i], messages::mission_check_message<"leg_too_long">()));
      return check;
    }
    planning::PlanRequest from_here = request;
    from_here.depart = rest.depart;
    auto timed = planning::evaluate_route(environment, places, from_here);
    if (timed) {
      if (check.findings.empty()) {
        check.timing = std::move(*timed);
        check.places = std::move(rest.places);
      }
      break;
    }
    const Infeasible& closed = timed.error();
    const bool at_start = concerns_start(closed.reason);
    const bool at_goal = concerns_goal(closed.reason);
    const std::size_t leg = at_start ? 1 : at_goal ? places.size() - 1 : leg_at(places, closed.at);
    check.findings.push_back(finding_of(closed, rest.places[at_start ? 0 : leg]));
    if (!is_dangerous(closed.reason)) break;  // beyond this the data tell nothing
    if (at_goal) {
      rest.places.pop_back();
      continue;
    }
    rest.depart = at_start ? rest.depart + spend(length_m(places[0], places[1]))
                           : closed.when + spend(length_m(closed.at, places[leg]));
    rest.places.erase(rest.places.begin(), rest.places.begin() + static_cast<std::ptrdiff_t>(leg));
  }
  std::ranges::stable_sort(check.findings, {}, &RouteFinding::place);
  return check;
}

std::vector<RouteFinding> check_depths(const ocean::Environment& environment,
                                       const std::vector<geo::LonLat>& route, const DiveArguments& dive) {
  std::vector<RouteFinding> findings;
  if (!environment.bathymetry) return findings;
  for (std::size_t i = 1; i < route.size() && findings.size() < most_findings; ++i) {
    const geo::GeodesicLine leg = geo::geodesic_between(route[i - 1], route[i]);
    if (leg.length.value > longest_leg_m) continue;
    std::optional<core::Metres> least;
    for (double along_m = 0.0; along_m <= leg.length.value; along_m += sample_step_m) {
      const auto bed = environment.bathymetry->shoalest(
          geo::geodesic_destination(route[i - 1], leg.course_at_start, core::Metres{along_m}));
      if (bed && (!least || *bed < *least)) least = bed;
    }
    if (!least) continue;
    if (auto finding = finding_of(dive, *least, i)) findings.push_back(std::move(*finding));
  }
  return findings;
}

}  // namespace floeplan::mission
