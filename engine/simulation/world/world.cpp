#include "engine/simulation/world/world.hpp"

#include <cmath>
#include <utility>

namespace floeplan::simulation {
namespace {

/// Validity of a search for bodies, in time and distance. A glider moves some thirty metres in a minute, so
/// the margin adds only few bodies, and one search serves many pings.
constexpr core::Seconds search_holds{60.0};
constexpr double search_margin_m = 100.0;

}  // namespace

World::World(WorldParts parts) : parts_{std::move(parts)}, projection_{parts_.origin} {}

bool World::covers(Vector place, core::UtcTime time) const {
  if (parts_.bed.has_data() && !bed_depth_m(place.east, place.north)) return false;
  return current(place, time).has_value();
}

Vector World::to_frame(geo::LonLat place, double depth_m) const {
  const geo::PlanePoint point = projection_.to_plane(place);
  return {point.x_m, point.y_m, depth_m};
}

geo::LonLat World::to_lon_lat(Vector place) const {
  return projection_.to_lon_lat({place.east, place.north});
}

std::vector<std::uint32_t> World::bodies_near(Vector place, double reach_m, core::UtcTime from,
                                              core::UtcTime to) const {
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < parts_.bodies.size(); ++i) {
    const Body& body = parts_.bodies[i];
    const BodyPose first = body.pose_at(from);
    const BodyPose last = body.pose_at(to);
    // Between two times a body stays in an ellipse around both places. A circle around the middle contains it
    // if the track is straight; half as much more is added for bends.
    const double span_m = std::hypot(last.east_m - first.east_m, last.north_m - first.north_m);
    const double aside_m = std::hypot(0.5 * (first.east_m + last.east_m) - place.east,
                                      0.5 * (first.north_m + last.north_m) - place.north);
    if (aside_m <= reach_m + body.shape().radius_m + 1.5 * span_m) near.push_back(i);
  }
  return near;
}

NearbyBodies::NearbyBodies(const World& world, core::Metres reach) : world_{world}, reach_m_{reach.value} {}

std::span<const NearbyBodies::Posed> NearbyBodies::at(Vector place, core::UtcTime time) {
  const double moved_m = std::hypot(place.east - sought_at_.east, place.north - sought_at_.north);
  if (!sought_ || time > good_until_ || moved_m > search_margin_m) {
    good_until_ = time + search_holds;
    sought_at_ = place;
    sought_ = true;
    near_.clear();
    for (const std::uint32_t i : world_.bodies_near(place, reach_m_ + search_margin_m, time, good_until_)) {
      near_.push_back({.body = &world_.bodies()[i], .index = i});
    }
  }
  for (Posed& posed : near_) posed.pose = posed.body->pose_at(time);
  return near_;
}

}  // namespace floeplan::simulation
