#include "engine/planning/publish/land_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/geo/coarse_outline.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/plane/coast_lines.hpp"
#include "engine/planning/plane/plane_lines.hpp"
#include "engine/planning/problem/position_error.hpp"
#include "engine/planning/publish/route_samples.hpp"

namespace floeplan::planning::publish {
namespace {

// Ratio of distances in the plane to those on the ground: 0.933 for polar stereographic planes at the pole, at least 1
// for the others.
constexpr double least_scale = 0.9;

/// A place on the route, and the position error there.
struct Sample {
  geo::PlanePoint point;
  core::Metres error{};
};

/// Sorted from west to east, in the plane.
struct Samples {
  std::vector<Sample> sorted;
  geo::BoundingBox bounds;
};

Samples sorted_samples(std::vector<Sample> samples, const geo::LocalProjection& projection) {
  std::vector<geo::LonLat> places;
  for (const Sample& sample : samples) places.push_back(projection.to_lon_lat(sample.point));
  std::ranges::sort(samples, {}, [](const Sample& sample) { return sample.point.x_m; });
  return {std::move(samples), geo::bounding_box(places)};
}

/// Calls `visit(sample, distance_m)` for each line of the coast near the route and each sample that may lie within `within_m()`
/// of it, which may shrink meanwhile.
template <class Within, class Visit>
void for_each_near_coast(const Samples& samples, const cost::Sea& sea, const ocean::Environment& environment,
                         core::Metres look, const Within& within_m, const Visit& visit) {
  const auto approach = [&](geo::PlanePoint a, geo::PlanePoint b) {
    const auto [west, east] = std::minmax(a.x_m, b.x_m);
    const auto [south, north] = std::minmax(a.y_m, b.y_m);
    auto sample = std::ranges::lower_bound(samples.sorted, west - within_m(), {},
                                           [](const Sample& each) { return each.point.x_m; });
    for (; sample != samples.sorted.end() && sample->point.x_m <= east + within_m(); ++sample) {
      if (sample->point.y_m < south - within_m() || sample->point.y_m > north + within_m()) continue;
      visit(*sample, plane::distance_to_line(sample->point, a, b));
    }
  };
  const geo::BoundingBox near = geo::grown(samples.bounds, look);
  for (const geo::Polygon& polygon : environment.land)
    plane::for_each_coast_line(geo::coarse_beyond(near, {polygon.outer, {}}).outer, sea.domain().projection(),
                               approach);
}

/// The time that the position error grows in open water: of one dive to the planned depth, at least, and of the
/// requested time between surfacings.
core::Seconds between_surfacings(const PlanRequest& request) {
  const vehicle::GliderProfile& vehicle = request.vehicle;
  const core::MetresPerSecond vertical = vehicle.vertical_speed(vehicle.speed_through_water);
  const core::Seconds dive = 2.0 * ((vehicle.dive_depth - vehicle.climb_to) / vertical);
  return std::max(dive, request.under_ice.surfacing_interval.value_or(core::Seconds{0.0}));
}

}  // namespace

std::optional<core::Metres> land_clearance(const cost::Sea& sea, const ocean::Environment& environment,
                                           const std::vector<geo::PlanePoint>& route) {
  constexpr core::Metres first_look{4000.0};
  constexpr core::Metres round_the_globe{2.1e7};
  if (environment.land.empty()) return std::nullopt;
  std::vector<Sample> along;
  for_each_sample(route, [&](std::size_t, double, geo::PlanePoint point) { along.push_back({point}); });
  const Samples samples = sorted_samples(std::move(along), sea.domain().projection());

  double least = std::numeric_limits<double>::infinity();
  // The search widens step by step, so that distant coasts cost little.
  for (core::Metres look = first_look;; look = 8.0 * look) {
    least = std::numeric_limits<double>::infinity();
    for_each_near_coast(
        samples, sea, environment, look, [&] { return least; },
        [&](const Sample&, double distance_m) { least = std::min(least, distance_m); });
    if (least <= least_scale * look.value || look > round_the_globe) break;
  }
  if (!std::isfinite(least)) return std::nullopt;
  return core::Metres{least};
}

std::optional<messages::Message> land_warning(const Plan& plan, const cost::Sea& sea,
                                              const ocean::Environment& environment,
                                              const PlanRequest& request,
                                              const std::vector<geo::PlanePoint>& route,
                                              const cost::Schedule& schedule) {
  if (environment.land.empty()) return std::nullopt;
  const core::Seconds longest = between_surfacings(request);
  const core::MetresPerSecond speed = request.vehicle.speed_through_water;
  core::Metres most{0.0};
  std::vector<Sample> along;
  for_each_sample(route, [&](std::size_t leg, double share, geo::PlanePoint point) {
    const core::Seconds left = leg > 0 ? schedule.leaves(leg - 1) : schedule.arrivals.front();
    const core::Seconds now = left + share * (schedule.arrivals[leg] - left);
    core::Metres error =
        grown_error(request.under_ice, speed, std::min(longest, now - schedule.arrivals.front()));
    if (plan.surfacing && leg > 0) error = std::max(error, plan.surfacing->waypoints[leg].position_error);
    most = std::max(most, error);
    along.push_back({point, error});
  });
  const Samples samples = sorted_samples(std::move(along), sea.domain().projection());

  std::optional<Sample> nearest;
  double least = std::numeric_limits<double>::infinity();
  for_each_near_coast(
      samples, sea, environment, core::Metres{most.value / least_scale}, [&] { return most.value; },
      [&](const Sample& sample, double distance_m) {
        if (distance_m >= sample.error.value || distance_m >= least) return;
        least = distance_m;
        nearest = sample;
      });
  if (!nearest) return std::nullopt;
  const geo::LonLat place = sea.domain().projection().to_lon_lat(nearest->point);
  return messages::plan_message<"passes-close-to-land">(place.lon_deg, place.lat_deg, least,
                                                        nearest->error.value)
      .at(place);
}

}  // namespace floeplan::planning::publish
