#include "engine/simulation/world/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace floeplan::simulation {
namespace {

BodyPoint turned(const BodyPose& pose, Vector v) {
  return {v.east * pose.sine + v.north * pose.cosine, v.east * pose.cosine - v.north * pose.sine, v.down};
}

Vector turned_back(const BodyPose& pose, const BodyPoint& p) {
  return {p.along * pose.sine + p.across * pose.cosine, p.along * pose.cosine - p.across * pose.sine, p.down};
}

BodyPoint seen_from(const BodyPose& pose, Vector point) {
  return turned(pose, point - Vector{pose.east_m, pose.north_m, 0.0});
}

/// Distance to the vertical cylinder, from the surface to the draft, that contains the whole shape under
/// water.
double cylinder_distance(const Shape& shape, const BodyPoint& point) {
  const double aside_m = std::hypot(point.along, point.across) - shape.radius_m;
  const double below_m = point.down - shape.draft_m;
  if (aside_m <= 0.0) return below_m;
  return below_m <= 0.0 ? aside_m : std::hypot(aside_m, below_m);
}

/// Index of the last fix at or before `time`, but at most the index of the last fix but one.
std::size_t stretch_at(const std::vector<Body::Fix>& track, core::UtcTime time) {
  const auto after = std::ranges::upper_bound(track, time, {}, &Body::Fix::time);
  const auto count = static_cast<std::size_t>(after - track.begin());
  return count == 0 ? 0 : std::min(count - 1, track.size() - 2);
}

}  // namespace

Body::Body(std::string name, Shape shape, Motion motion)
    : name_{std::move(name)}, shape_{std::move(shape)}, motion_{std::move(motion)} {
  if (shape_.parts.empty()) throw std::invalid_argument{"a body has one part or more"};
  if (motion_.track.empty()) throw std::invalid_argument{"a body has one fix or more"};
  const auto falls_back = [](const Fix& a, const Fix& b) { return !(a.time < b.time); };
  if (std::ranges::adjacent_find(motion_.track, falls_back) != motion_.track.end()) {
    throw std::invalid_argument{"the times of a track ascend"};
  }
}

BodyPose Body::pose_at(core::UtcTime time) const {
  const std::vector<Fix>& track = motion_.track;
  const core::UtcTime within = std::clamp(time, track.front().time, track.back().time);
  BodyPose pose{.east_m = track.front().east_m, .north_m = track.front().north_m};
  if (track.size() > 1) {
    const std::size_t i = stretch_at(track, within);
    const double share = (within - track[i].time) / (track[i + 1].time - track[i].time);
    pose.east_m = std::lerp(track[i].east_m, track[i + 1].east_m, share);
    pose.north_m = std::lerp(track[i].north_m, track[i + 1].north_m, share);
  }
  const double heading_rad = motion_.heading_rad + motion_.spin_rad_s * (time - track.front().time).count();
  pose.sine = std::sin(heading_rad);
  pose.cosine = std::cos(heading_rad);
  return pose;
}

Vector Body::velocity_at(core::UtcTime time) const {
  const std::vector<Fix>& track = motion_.track;
  if (track.size() == 1 || time < track.front().time || time > track.back().time) return {};
  const std::size_t i = stretch_at(track, time);
  const double span_s = (track[i + 1].time - track[i].time).count();
  return {(track[i + 1].east_m - track[i].east_m) / span_s,
          (track[i + 1].north_m - track[i].north_m) / span_s, 0.0};
}

bool Body::contains(const BodyPose& pose, Vector point) const {
  const BodyPoint seen = seen_from(pose, point);
  return std::ranges::any_of(shape_.parts, [&](const ConvexPart& part) { return part.contains(seen); });
}

double Body::least_distance(const BodyPose& pose, Vector point) const {
  const BodyPoint seen = seen_from(pose, point);
  const double to_cylinder_m = cylinder_distance(shape_, seen);
  if (to_cylinder_m > shape_.radius_m) return to_cylinder_m;
  double least_m = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : shape_.parts) least_m = std::min(least_m, part.plane_distance(seen));
  return least_m;
}

double Body::distance(const BodyPose& pose, Vector point) const {
  const BodyPoint seen = seen_from(pose, point);
  double least_m = std::numeric_limits<double>::infinity();
  for (const ConvexPart& part : shape_.parts) {
    if (part.plane_distance(seen) < least_m) least_m = std::min(least_m, part.distance(seen));
  }
  return least_m;
}

std::optional<BodyHit> Body::first_hit(const BodyPose& pose, Vector origin, Vector direction,
                                       double max_range_m) const {
  const BodyPoint from = seen_from(pose, origin);
  const BodyPoint along = turned(pose, direction);
  std::optional<BodyHit> first;
  for (const ConvexPart& part : shape_.parts) {
    const auto hit = part.first_hit(from, along, first ? first->range_m : max_range_m);
    if (hit) first = BodyHit{.range_m = hit->range_m, .normal = turned_back(pose, hit->normal)};
  }
  return first;
}

}  // namespace floeplan::simulation
