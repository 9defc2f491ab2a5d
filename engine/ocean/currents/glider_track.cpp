#include "engine/ocean/currents/glider_track.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace floeplan::ocean {
namespace {

double depth_or_surface(const TrackPoint& point) { return point.depth.value_or(core::Metres{0.0}).value; }

/// The place at a share of the line between two places; longitudes take the short way round.
geo::LonLat between(geo::LonLat from, geo::LonLat to, double share) {
  const double step_deg = geo::longitude_difference(from.lon_deg, to.lon_deg);
  return {geo::wrap_longitude(from.lon_deg + share * step_deg),
          from.lat_deg + share * (to.lat_deg - from.lat_deg)};
}

}  // namespace

std::string_view frame_name(CurrentFrame frame) {
  switch (frame) {
    case CurrentFrame::stated: return "stated";
    case CurrentFrame::turned: return "true";
    case CurrentFrame::vehicle: return "vehicle";
  }
  throw std::logic_error{"a frame without a name"};
}

std::optional<CurrentFrame> parse_current_frame(std::string_view name) {
  for (const auto frame : {CurrentFrame::stated, CurrentFrame::turned, CurrentFrame::vehicle})
    if (frame_name(frame) == name) return frame;
  return std::nullopt;
}

std::optional<core::Metres> deepest(const std::vector<TrackPoint>& points) {
  std::optional<core::Metres> greatest;
  for (const TrackPoint& point : points)
    if (point.depth && (!greatest || *greatest < *point.depth)) greatest = point.depth;
  return greatest;
}

std::optional<geo::VelocityEn> mean_current(const std::vector<DepthAveragedCurrent>& currents) {
  if (currents.empty()) return std::nullopt;
  double east = 0.0;
  double north = 0.0;
  for (const DepthAveragedCurrent& each : currents) {
    east += each.current.east.value;
    north += each.current.north.value;
  }
  const auto count = static_cast<double>(currents.size());
  return geo::VelocityEn{{east / count}, {north / count}};
}

geo::BoundingBox bounding_box(const GliderTrack& track) {
  std::vector<geo::LonLat> places;
  places.reserve(track.points.size() + track.currents.size());
  for (const TrackPoint& point : track.points) places.push_back(point.place);
  for (const DepthAveragedCurrent& each : track.currents) places.push_back(each.place);
  return geo::bounding_box(places);
}

std::vector<TrackPoint> thinned(const std::vector<TrackPoint>& points, std::size_t most) {
  if (points.size() <= most) return points;
  const std::size_t inner = points.size() - 2;
  const std::size_t parts = most < 4 ? 0 : (most - 2) / 2;
  std::vector<TrackPoint> kept{points.front()};
  for (std::size_t part = 0; part < parts; ++part) {
    const auto begin = points.begin() + 1 + static_cast<std::ptrdiff_t>(inner * part / parts);
    const auto end = points.begin() + 1 + static_cast<std::ptrdiff_t>(inner * (part + 1) / parts);
    const auto [shallow, deep] = std::ranges::minmax_element(begin, end, {}, depth_or_surface);
    kept.push_back(*std::min(shallow, deep));
    if (shallow != deep) kept.push_back(*std::max(shallow, deep));
  }
  kept.push_back(points.back());
  return kept;
}

std::vector<double> depths_along(const std::vector<TrackPoint>& points) {
  std::vector<double> depths_m(points.size());
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].depth) continue;
    const double deep_m = points[i].depth->value;
    const double from_m = before ? depths_m[*before] : deep_m;
    const core::UtcTime since = points[before.value_or(i)].time;
    const core::Seconds step = points[i].time - since;
    for (std::size_t k = before ? *before + 1 : 0; k < i; ++k)
      depths_m[k] =
          before && step.count() > 0.0 ? std::lerp(from_m, deep_m, (points[k].time - since) / step) : deep_m;
    depths_m[i] = deep_m;
    before = i;
  }
  if (!before) return {};
  for (std::size_t k = *before + 1; k < points.size(); ++k) depths_m[k] = depths_m[*before];
  return depths_m;
}

geo::LonLat place_at(const std::vector<TrackPoint>& points, core::UtcTime time) {
  if (points.empty()) throw std::invalid_argument{"a track without points is nowhere"};
  const auto after = std::ranges::upper_bound(points, time, {}, &TrackPoint::time);
  if (after == points.begin()) return points.front().place;
  if (after == points.end()) return points.back().place;
  const TrackPoint& before = *std::prev(after);
  return between(before.place, after->place, (time - before.time) / (after->time - before.time));
}

}  // namespace floeplan::ocean
