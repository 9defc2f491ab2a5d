#include "engine/simulation/sensors/sound_rays.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::simulation {
namespace {

constexpr double least_step_m = 1.0;  // along a ray, close to the sea bed
constexpr double slope_step_m = 5.0;  // distance over which the bed's slope is computed

Vector along(Vector origin, Vector direction, double range_m) { return origin + range_m * direction; }

}  // namespace

SoundRays::SoundRays(const World& world, core::Metres reach)
    : world_{world}, reach_m_{reach.value}, nearby_{world, reach}, bed_{world, reach} {}

void SoundRays::look_from(Vector place, core::UtcTime time) {
  time_ = time;
  bodies_.clear();
  for (const NearbyBodies::Posed& posed : nearby_.at(place, time)) {
    if (posed.body->least_distance(posed.pose, place) > reach_m_) continue;
    const Shape& shape = posed.body->shape();
    const double half_draft_m = 0.5 * shape.draft_m;
    const Vector centre = Vector{posed.pose.east_m, posed.pose.north_m, half_draft_m} - place;
    bodies_.push_back({posed, centre, dot(centre, centre),
                       std::sqrt(shape.radius_m * shape.radius_m + half_draft_m * half_draft_m)});
  }
  bed_.look_from(place);
  const auto shallowest_m = bed_.shallowest_m();
  near_bed_ = shallowest_m && *shallowest_m - place.down <= reach_m_;
}

bool SoundRays::InReach::is_missed_by(Vector direction, double max_range_m) const {
  const double ahead_m = dot(centre, direction);
  if (ahead_m < -radius_m || ahead_m - radius_m > max_range_m) return true;
  return centre_m2 - ahead_m * ahead_m > radius_m * radius_m;
}

std::optional<RayHit> SoundRays::operator()(Vector origin, Vector direction, double max_range_m) const {
  std::optional<RayHit> nearest;
  double range_m = max_range_m;
  for (const InReach& body : bodies_) {
    if (body.is_missed_by(direction, range_m)) continue;
    if (const auto hit = body.posed.body->first_hit(body.posed.pose, origin, direction, range_m)) {
      range_m = hit->range_m;
      nearest = RayHit{range_m, std::clamp(-dot(hit->normal, direction), 0.0, 1.0), Scatterer::ice};
    }
  }
  if (const auto hit = surface_hit(origin, direction, range_m)) {
    range_m = hit->range_m;
    nearest = hit;
  }
  if (near_bed_) {
    if (const auto hit = bed_hit(origin, direction, range_m)) nearest = hit;
  }
  return nearest;
}

std::optional<RayHit> SoundRays::surface_hit(Vector origin, Vector direction, double max_range_m) const {
  if (direction.down >= 0.0) return std::nullopt;
  const double to_surface_m = origin.down / -direction.down;
  double draft_m = 0.0;
  if (world_.has_ice()) {
    const Vector above = along(origin, direction, std::min(to_surface_m, max_range_m));
    draft_m = world_.ice_draft_m(above.east, above.north, time_);
  }
  const double range_m = std::max(0.0, (origin.down - draft_m) / -direction.down);
  if (range_m > max_range_m) return std::nullopt;
  return RayHit{range_m, -direction.down, draft_m > 0.0 ? Scatterer::ice : Scatterer::open_surface};
}

/// Steps along the ray as long as the steepest slope of the bed allows, so that no step passes through it;
/// short ones near it.
std::optional<RayHit> SoundRays::bed_hit(Vector origin, Vector direction, double max_range_m) const {
  const double level = std::sqrt(direction.east * direction.east + direction.north * direction.north);
  const double closing =
      direction.down + bed_.steepest() * level;  // upper bound: metres of height lost per metre of ray
  double before_m = 0.0;
  double height_before_m = 0.0;
  double range_m = 0.0;
  for (;;) {
    const Vector place = along(origin, direction, range_m);
    const auto depth_m = bed_.depth_m(place.east, place.north);
    if (!depth_m) return std::nullopt;
    const double height_m = *depth_m - place.down;
    if (height_m <= 0.0) {
      // The last step was short, so the bed is linear between its ends.
      const double share = range_m > 0.0 ? height_before_m / (height_before_m - height_m) : 0.0;
      const double hit_m = std::lerp(before_m, range_m, share);
      return RayHit{hit_m, cosine_on_bed(along(origin, direction, hit_m), direction), Scatterer::sea_bed};
    }
    if (height_m > closing * (max_range_m - range_m)) return std::nullopt;
    before_m = range_m;
    height_before_m = height_m;
    range_m = std::min(max_range_m, range_m + std::max(least_step_m, height_m / closing));
  }
}

double SoundRays::cosine_on_bed(Vector foot, Vector direction) const {
  const auto depth_at = [&](double east_m, double north_m) {
    return bed_.depth_m(foot.east + east_m, foot.north + north_m).value_or(foot.down);
  };
  const double deeper_east =
      (depth_at(slope_step_m, 0.0) - depth_at(-slope_step_m, 0.0)) / (2.0 * slope_step_m);
  const double deeper_north =
      (depth_at(0.0, slope_step_m) - depth_at(0.0, -slope_step_m)) / (2.0 * slope_step_m);
  const double steepness = std::sqrt(1.0 + deeper_east * deeper_east + deeper_north * deeper_north);
  const double cosine =
      (direction.down - deeper_east * direction.east - deeper_north * direction.north) / steepness;
  return std::clamp(cosine, 0.0, 1.0);
}

}  // namespace floeplan::simulation
