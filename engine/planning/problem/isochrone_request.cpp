#include "engine/planning/problem/isochrone_request.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>

namespace floeplan::planning {
namespace {

constexpr double data_radius_factor = 3.0;
constexpr double steps_per_radius = 100.0;  // in still water
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
  // A few steps at least, so that the border of a short reach lies inside the grid.
  constexpr double fewest_steps = 10.0;
  const double still_water_m = through_water().value * reach().count();
  return core::Metres{std::max(data_radius_factor * still_water_m, fewest_steps * step().value)};
}

core::Violations IsochroneRequest::violations() const {
  core::Violations found = vehicle.violations();
  const auto require = [&](bool holds, std::string field, std::string rule) {
    if (!holds) found.push_back({std::move(field), std::move(rule)});
  };
  require(geo::is_valid(place), direction == Direction::from ? "/from" : "/to",
          "must be [longitude, latitude] in degrees, longitude -180 to 360, latitude -90 to 90");
  require(std::isfinite(core::unix_seconds(time)), direction == Direction::from ? "/depart" : "/arrive_by",
          "must be a time");
  require(!spans.empty() && spans.size() <= most_spans, "/hours",
          "must be 1 to " + std::to_string(most_spans) + " times");
  for (const core::Seconds span : spans) {
    require(span.count() > 0.0 && span <= longest_span, "/hours",
            "must be more than 0 and at most 720 hours");
  }
  require(!sectors || (*sectors >= 1 && *sectors <= 5), "/sectors", "must be 1, 2, 3, 4 or 5");
  require(!spacing || (spacing->value >= 1.0 && spacing->value <= 100'000.0), "/spacing_m",
          "must be between 1 m and 100 km");
  std::ranges::move(icebergs.violations(), std::back_inserter(found));
  std::ranges::move(under_ice.violations(), std::back_inserter(found));
  return found;
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
  voyage.departures.until = request.end();  // icebergs drift as long as it is under way
  voyage.vehicle = request.vehicle;
  if (request.sectors) voyage.sectors = *request.sectors;
  voyage.zones = request.zones;
  voyage.icebergs = request.icebergs;
  voyage.under_ice = request.under_ice;
  voyage.edge_tolerance = request.edge_tolerance;
  return voyage;
}

}  // namespace floeplan::planning
