#include "engine/planning/problem/isochrone_request.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/messages/fault.hpp"

namespace floeplan::planning {
namespace {

constexpr double data_radius_factor = 3.0;
constexpr double steps_per_radius = 100.0;  // default spacing: a share of the distance in still water
constexpr double least_step_m = 100.0;
constexpr double most_step_m = 5000.0;

}  // namespace

core::Seconds IsochroneRequest::reach() const { return *std::ranges::max_element(spans); }

core::UtcTime IsochroneRequest::begin() const { return direction == Direction::from ? time : time - reach(); }

core::UtcTime IsochroneRequest::end() const { return direction == Direction::from ? time + reach() : time; }

core::MetresPerSecond IsochroneRequest::through_water() const {
  return drive_speed(vehicle, drives(voyage_of(*this).energy, vehicle).front());
}

core::Metres IsochroneRequest::step() const {
  const double still_water_m = through_water().value * reach().count();
  return spacing.value_or(
      core::Metres{std::clamp(still_water_m / steps_per_radius, least_step_m, most_step_m)});
}

core::Metres IsochroneRequest::data_radius() const {
  // At least this number of steps, so that the outline of a small isochrone lies inside the grid.
  constexpr double fewest_steps = 10.0;
  const double still_water_m = through_water().value * reach().count();
  return core::Metres{std::max(data_radius_factor * still_water_m, fewest_steps * step().value)};
}

core::Violations IsochroneRequest::violations() const {
  messages::Faults faults;
  faults.take(vehicle.violations());
  faults.require<"not-a-place">(geo::is_valid(place), direction == Direction::from ? "/from" : "/to");
  faults.require<"not-a-time">(std::isfinite(core::unix_seconds(time)),
                               direction == Direction::from ? "/depart" : "/arrive_by");
  faults.require<"not-so-many-times">(!spans.empty() && spans.size() <= most_spans, "/hours", most_spans);
  for (const core::Seconds span : spans)
    faults.require<"not-above">(span.count() > 0.0 && span <= longest_span, "/hours", "0", "720 hours");
  faults.require<"unknown-neighbourhood">(!sectors || (*sectors >= 1 && *sectors <= 5), "/sectors");
  faults.require<"not-between">(!spacing || (spacing->value >= 1.0 && spacing->value <= 100'000.0),
                                "/spacing_m", "1 m", "100 km");
  faults.take(icebergs.violations());
  faults.take(under_ice.violations());
  return faults.found();
}

geo::BoundingBox reach_area(const IsochroneRequest& request) {
  const std::array place{request.place};
  return geo::grown(geo::bounding_box(place), request.data_radius());
}

PlanRequest voyage_of(const IsochroneRequest& request) {
  PlanRequest voyage;
  voyage.from = request.place;
  voyage.to = request.place;
  voyage.depart = request.begin();
  voyage.departures.until = request.end();  // icebergs drift until the end of the last span
  voyage.vehicle = request.vehicle;
  if (request.sectors) voyage.sectors = *request.sectors;
  voyage.zones = request.zones;
  voyage.icebergs = request.icebergs;
  voyage.under_ice = request.under_ice;
  voyage.edge_tolerance = request.edge_tolerance;
  return voyage;
}

}  // namespace floeplan::planning
