#include "engine/simulation/sound_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace floeplan::simulation {
namespace {

constexpr double least_step_m = 1.0;  // along a ray, close above the sea bed
constexpr double step_share =
    0.5;  // of the height above the bed: a ray cannot meet a slope of 60 degrees sooner
constexpr double slope_step_m = 5.0;  // over which the slope of the sea bed is taken
constexpr int halvings = 8;           // of the last step: to half a centimetre and better
constexpr int bed_samples = 8;        // around the vehicle, at half the reach and at all of it

Vector along(Vector origin, Vector direction, double range_m) { return origin + range_m * direction; }

}  // namespace

SoundRays::SoundRays(const World& world, core::Metres reach)
    : world_{world}, reach_m_{reach.value}, nearby_{world, reach} {}

void SoundRays::look_from(Vector place, core::UtcTime time) {
  time_ = time;
  bodies_.clear();
  for (const NearbyBodies::Posed& posed : nearby_.at(place, time)) {
    if (posed.body->least_distance(posed.pose, place) <= reach_m_) bodies_.push_back(posed);
  }
  near_bed_ = bed_within_reach(place);
}

std::optional<RayHit> SoundRays::operator()(Vector origin, Vector direction, double max_range_m) const {
  std::optional<RayHit> nearest;
  double range_m = max_range_m;
  for (const NearbyBodies::Posed& posed : bodies_) {
    if (const auto hit = posed.body->first_hit(posed.pose, origin, direction, range_m)) {
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
  const Vector above = along(origin, direction, std::min(to_surface_m, max_range_m));
  const double draft_m = world_.ice_draft_m(above.east, above.north, time_);
  const double range_m = std::max(0.0, (origin.down - draft_m) / -direction.down);
  if (range_m > max_range_m) return std::nullopt;
  return RayHit{range_m, -direction.down, draft_m > 0.0 ? Scatterer::ice : Scatterer::open_surface};
}

std::optional<double> SoundRays::above_bed(Vector place) const {
  const auto bed_m = world_.bed_depth_m(place.east, place.north);
  if (!bed_m) return std::nullopt;
  return *bed_m - place.down;
}

bool SoundRays::bed_within_reach(Vector place) const {
  const auto within = [&](double east_m, double north_m) {
    const auto bed_m = world_.bed_depth_m(place.east + east_m, place.north + north_m);
    return bed_m && *bed_m - place.down <= reach_m_;
  };
  if (within(0.0, 0.0)) return true;
  for (int i = 0; i < bed_samples; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / bed_samples;
    const double east_m = reach_m_ * std::sin(angle);
    const double north_m = reach_m_ * std::cos(angle);
    if (within(east_m, north_m) || within(0.5 * east_m, 0.5 * north_m)) return true;
  }
  return false;
}

std::optional<RayHit> SoundRays::bed_hit(Vector origin, Vector direction, double max_range_m) const {
  double before_m = 0.0;
  double range_m = 0.0;
  for (;;) {
    const auto height_m = above_bed(along(origin, direction, range_m));
    if (!height_m) return std::nullopt;
    if (*height_m <= 0.0) break;
    if (range_m >= max_range_m) return std::nullopt;
    before_m = range_m;
    range_m = std::min(max_range_m, range_m + std::max(least_step_m, step_share * *height_m));
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle_m = 0.5 * (before_m + range_m);
    const auto height_m = above_bed(along(origin, direction, middle_m));
    (height_m && *height_m > 0.0 ? before_m : range_m) = middle_m;
  }

  const Vector foot = along(origin, direction, range_m);
  const auto depth_at = [&](double east_m, double north_m) {
    return world_.bed_depth_m(foot.east + east_m, foot.north + north_m).value_or(foot.down);
  };
  const double deeper_east =
      (depth_at(slope_step_m, 0.0) - depth_at(-slope_step_m, 0.0)) / (2.0 * slope_step_m);
  const double deeper_north =
      (depth_at(0.0, slope_step_m) - depth_at(0.0, -slope_step_m)) / (2.0 * slope_step_m);
  const double steepness = std::sqrt(1.0 + deeper_east * deeper_east + deeper_north * deeper_north);
  const double cosine =
      (direction.down - deeper_east * direction.east - deeper_north * direction.north) / steepness;
  return RayHit{range_m, std::clamp(cosine, 0.0, 1.0), Scatterer::sea_bed};
}

}  // namespace floeplan::simulation
