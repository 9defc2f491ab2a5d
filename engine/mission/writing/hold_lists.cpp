#include "engine/mission/writing/hold_lists.hpp"

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/mission/writing/below_ice.hpp"

namespace floeplan::mission {
namespace {

constexpr double step_of_currents_s = 1800.0;
constexpr int depths_of_mean = 8;

/// Mean current over the depths flown, as far down as there is water.
std::optional<geo::VelocityEn> mean_over_band(const ocean::CurrentGrid& currents, geo::LonLat place,
                                              const vehicle::DiveBand& band, core::UtcTime time) {
  geo::VelocityEn sum;
  int known = 0;
  for (int i = 0; i < depths_of_mean; ++i) {
    const core::Metres depth = band.top + ((i + 0.5) / depths_of_mean) * band.thickness();
    const auto current = currents.at(place, depth, time);
    if (!current) break;
    sum = geo::sum(sum, *current);
    ++known;
  }
  if (known == 0) return std::nullopt;
  return geo::VelocityEn{{sum.east.value / known}, {sum.north.value / known}};
}

std::vector<geo::VelocityEn> currents_of_hold(const ocean::Environment& sea, const planning::Waypoint& held,
                                              const vehicle::DiveBand& band) {
  const double steps = sea.steady_currents ? 0.0 : std::ceil(held.wait.count() / step_of_currents_s);
  std::vector<geo::VelocityEn> currents;
  for (double step = 0.0; step <= steps; step += 1.0) {
    const core::UtcTime time = sea.steady_currents ? core::from_unix_seconds(sea.currents->times_s().front())
                                                   : held.eta + (step / steps) * held.wait;
    const auto current = mean_over_band(*sea.currents, held.place, band, time);
    if (!current) return {};
    currents.push_back(*current);
  }
  return currents;
}

std::vector<geo::VelocityEn> currents_at(const planning::Plan& plan, std::size_t waypoint,
                                         const HoldOptions& options) {
  if (waypoint < options.currents.size() && !options.currents[waypoint].empty())
    return options.currents[waypoint];
  std::vector<geo::VelocityEn> currents;
  for (const std::size_t leg : {waypoint, waypoint + 1})
    if (const auto& current = plan.waypoints[leg].current) currents.push_back(*current);
  return currents;
}

}  // namespace

bool is_held_at(const planning::Plan& plan, std::size_t waypoint) {
  return waypoint + 1 < plan.waypoints.size() && plan.waypoints[waypoint].wait >= least_listed_hold &&
         overhead(plan, waypoint) != Overhead::closed;
}

bool has_holds(const planning::Plan& plan) {
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i)
    if (is_held_at(plan, i)) return true;
  return false;
}

std::vector<std::vector<geo::VelocityEn>> hold_currents(const ocean::Environment& sea,
                                                        const planning::Plan& plan,
                                                        const vehicle::GliderProfile& vehicle) {
  std::vector<std::vector<geo::VelocityEn>> currents(plan.waypoints.size());
  if (!sea.currents) return currents;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& waypoint = plan.waypoints[i];
    if (is_held_at(plan, i))
      currents[i] =
          currents_of_hold(sea, waypoint, vehicle::flown_band(vehicle.dive_limits(), waypoint.depth));
  }
  return currents;
}

HoldFlight hold_flight(const planning::Plan& plan, std::size_t waypoint, const HoldOptions& options) {
  const planning::Waypoint& place = plan.waypoints[waypoint];
  const planning::Waypoint& next = plan.waypoints[waypoint + 1];
  const core::MetresPerSecond speed = next.speed_through_water.value_or(options.vehicle.speed_through_water);
  return {.wait = place.wait,
          .circle = options.radius,
          .speed = speed,
          .vertical = options.vehicle.vertical_speed(speed),
          .band = vehicle::flown_band(options.vehicle.dive_limits(), place.depth),
          .surfaces = options.surfaces && least_upper_turn(plan).value <= 0.0,
          .between_surfacings = options.between_surfacings,
          .course = geo::geodesic_between(place.place, next.place).course_at_start,
          .currents = currents_at(plan, waypoint, options)};
}

std::vector<messages::Message> messages_without_holds(const planning::Plan& plan, const std::string& format) {
  std::vector<messages::Message> told;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const planning::Waypoint& waypoint = plan.waypoints[i];
    if (waypoint.wait < least_listed_hold) continue;
    told.push_back(messages::export_message<"format-without-holds">(waypoint.wait.count() / 3600.0, i, format,
                                                                    waypoint.eta + waypoint.wait)
                       .at(waypoint.place));
  }
  return told;
}

std::vector<geo::LonLat> hold_rows(geo::LonLat place, const HoldLegs& legs) {
  const core::Metres half = 0.5 * legs.apart;
  const geo::Bearing back = geo::Bearing::towards(-legs.axis.east(), -legs.axis.north());
  return {geo::geodesic_destination(place, back, half), geo::geodesic_destination(place, legs.axis, half)};
}

}  // namespace floeplan::mission
