#include "engine/planning/timed_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace floeplan::planning {
namespace {

TimeSpan span_of(const ocean::Zone& zone, core::UtcTime epoch) {
  return {zone.from ? *zone.from - epoch : core::Seconds{-INFINITY},
          zone.until ? *zone.until - epoch : core::Seconds{INFINITY}};
}

bool overlap(const TimeSpan& a, const TimeSpan& b) { return a.from <= b.until && b.from <= a.until; }

TimeSpan common(const TimeSpan& a, const TimeSpan& b) {
  return {std::max(a.from, b.from), std::min(a.until, b.until)};
}

/// The way made at a time inside the piece: its cubic.
double way_at(const motion::EdgePiece& piece, double t_s) {
  const double h = piece.t1_s - piece.t0_s;
  if (h <= 0.0) return piece.way1_m;
  const double x = std::clamp((t_s - piece.t0_s) / h, 0.0, 1.0);
  const double gain = piece.way1_m - piece.way0_m;
  const double v0 = h * piece.v0_m_s;
  const double v1 = h * piece.v1_m_s;
  return piece.way0_m + x * (v0 + x * (3.0 * gain - 2.0 * v0 - v1 + x * (v0 + v1 - 2.0 * gain)));
}

}  // namespace

TimedZones::TimedZones(const std::vector<ocean::Zone>& zones, const geo::LocalProjection& projection,
                       core::UtcTime epoch) {
  for (const ocean::Zone& zone : zones) {
    auto& areas = zone.kind == ocean::ZoneKind::no_go ? no_go_ : stay_in_;
    areas.push_back({PlanePolygon{zone.area, projection}, span_of(zone, epoch)});
  }
  for (const Area& area : stay_in_) {
    for (const core::Seconds end : {area.in_force.from, area.in_force.until}) {
      if (std::isfinite(end.count())) changes_s_.push_back(end.count());
    }
  }
  std::ranges::sort(changes_s_);
}

template <class PlaceAt>
bool TimedZones::forbid_during(TimeSpan during, const PlaceAt& place_at) const {
  for (const Area& area : no_go_) {
    if (!overlap(area.in_force, during)) continue;
    const TimeSpan inside = common(area.in_force, during);
    if (area.polygon.meets(place_at(inside.from), place_at(inside.until))) return true;
  }
  if (stay_in_.empty()) return false;

  // Between two changes the same zones are in force.
  core::Seconds from = during.from;
  while (true) {
    const auto change = std::ranges::upper_bound(changes_s_, from.count());
    const core::Seconds until =
        change == changes_s_.end() ? during.until : std::min(during.until, core::Seconds{*change});
    const core::Seconds middle = from + 0.5 * (until - from);
    std::vector<const PlanePolygon*> in_force;
    for (const Area& area : stay_in_) {
      if (overlap(area.in_force, {middle, middle})) in_force.push_back(&area.polygon);
    }
    if (!in_force.empty() && !covered(in_force, place_at(from), place_at(until))) return true;
    if (until >= during.until) return false;
    from = until;
  }
}

bool TimedZones::forbid(const motion::PlaneEdge& edge, const motion::EdgePiece& piece) const {
  return forbid_during({core::Seconds{piece.t0_s}, core::Seconds{piece.t1_s}}, [&](core::Seconds time) {
    const double share = std::min(way_at(piece, time.count()) / edge.ground_length.value, 1.0);
    return geo::PlanePoint{edge.from.x_m + share * (edge.to.x_m - edge.from.x_m),
                           edge.from.y_m + share * (edge.to.y_m - edge.from.y_m)};
  });
}

bool TimedZones::forbid(geo::PlanePoint a, geo::PlanePoint b, TimeSpan during) const {
  const double duration_s = (during.until - during.from).count();
  return forbid_during(during, [&](core::Seconds time) {
    const double share = duration_s > 0.0 ? (time - during.from).count() / duration_s : 0.0;
    return geo::PlanePoint{a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)};
  });
}

std::vector<TimeSpan> TimedZones::closed_times(geo::PlanePoint point) const {
  std::vector<TimeSpan> closed;
  for (const Area& area : no_go_) {
    if (area.polygon.contains(point)) closed.push_back(area.in_force);
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<double> ends{-never};
  ends.insert(ends.end(), changes_s_.begin(), changes_s_.end());
  ends.push_back(never);
  for (std::size_t i = 1; i < ends.size() && !stay_in_.empty(); ++i) {
    const TimeSpan span{core::Seconds{ends[i - 1]}, core::Seconds{ends[i]}};
    bool confined = false;
    bool inside = false;
    for (const Area& area : stay_in_) {
      if (area.in_force.from > span.from || area.in_force.until < span.until) continue;
      confined = true;
      inside = inside || area.polygon.contains(point);
    }
    if (confined && !inside) closed.push_back(span);
  }
  return joined(std::move(closed));
}

}  // namespace floeplan::planning
