#include "engine/mission/writing/shoals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/geo/geodesic.hpp"

namespace floeplan::mission {
namespace {

/// Distance between samples. Steep banks rise by a third, so between two samples the bed is shoaler by at
/// most 4 m.
constexpr double step_m = 25.0;

void take(std::optional<Shoal>& least, const Shoal& found) {
  if (!least || found.bed < least->bed) least = found;
}

}  // namespace

std::vector<std::optional<Shoal>> shoals_along(const ocean::Bathymetry& bathymetry,
                                               const planning::Plan& plan) {
  std::vector<std::optional<Shoal>> shoals(plan.waypoints.size());
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const geo::LonLat from = plan.waypoints[i - 1].place;
    const geo::GeodesicLine leg = geo::geodesic_between(from, plan.waypoints[i].place);
    const double steps = std::max(1.0, std::ceil(leg.length.value / step_m));
    for (double step = 0.0; step <= steps; step += 1.0) {
      const core::Metres along{leg.length.value * step / steps};
      const geo::LonLat place = geo::geodesic_destination(from, leg.course_at_start, along);
      if (const auto bed = bathymetry.shoalest(place)) take(shoals[i], {*bed, place, i});
    }
  }
  return shoals;
}

std::optional<Shoal> shoalest_of(const planning::Plan& plan,
                                 const std::vector<std::optional<Shoal>>& shoals) {
  std::optional<Shoal> least;
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    if (const auto depth = plan.waypoints[i].depth)
      take(least, {*depth, plan.waypoints[i].place, std::max<std::size_t>(i, 1)});
  }
  for (const auto& shoal : shoals) {
    if (shoal) take(least, *shoal);
  }
  return least;
}

std::string place_text(geo::LonLat place) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.4f, %.4f", place.lon_deg, place.lat_deg);
  return text.data();
}

}  // namespace floeplan::mission
