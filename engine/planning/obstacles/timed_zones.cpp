#include "engine/planning/obstacles/timed_zones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace floeplan::planning::obstacles {
namespace {

TimeSpan span_of(const ocean::Zone& zone, core::UtcTime epoch) {
  return {zone.from ? *zone.from - epoch : core::Seconds{-INFINITY},
          zone.until ? *zone.until - epoch : core::Seconds{INFINITY}};
}

bool overlap(const TimeSpan& a, const TimeSpan& b) { return a.from <= b.until && b.from <= a.until; }

TimeSpan common(const TimeSpan& a, const TimeSpan& b) {
  return {std::max(a.from, b.from), std::min(a.until, b.until)};
}

/// The distance covered at a time inside the piece, from its cubic.
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
                       const plane::PlaneBox& area, core::UtcTime epoch, Room room)
    : room_{room} {
  for (const ocean::Zone& zone : zones) {
    Areas& areas = zone.kind == ocean::ZoneKind::no_go ? no_go_ : stay_in_;
    areas.add({plane::PlanePolygon{zone.area, projection}, span_of(zone, epoch)});
  }
  no_go_.index(area);
  stay_in_.index(area);
  for (const Area& each : stay_in_.all()) {
    confined_.push_back(each.in_force);
    for (const core::Seconds end : {each.in_force.from, each.in_force.until}) {
      if (std::isfinite(end.count())) changes_s_.push_back(end.count());
    }
  }
  confined_ = joined(std::move(confined_));
  std::ranges::sort(changes_s_);
}

void TimedZones::Areas::index(const plane::PlaneBox& within) {
  constexpr double most_cells = 64.0;   // on each side
  constexpr double most_copies = 16.0;  // of a zone on average: a large zone is listed in many cells
  const double side_m = std::max(within.width_m(), within.height_m());
  std::vector<DiscIndex::Entry> entries;
  entries.reserve(areas_.size());
  for (const Area& area : areas_)
    entries.push_back({static_cast<std::uint32_t>(entries.size()), area.polygon.box(), whenever});
  const auto copies = [&](double cell_m) {
    const auto cells = [&](double low, double high, double first, double last) {
      return std::floor(std::clamp(high, first, last) / cell_m) -
             std::floor(std::clamp(low, first, last) / cell_m) + 1.0;
    };
    double all = 0.0;
    for (const DiscIndex::Entry& entry : entries)
      all += cells(entry.box.low.x_m, entry.box.high.x_m, within.low.x_m, within.high.x_m) *
             cells(entry.box.low.y_m, entry.box.high.y_m, within.low.y_m, within.high.y_m);
    return all;
  };
  double cell_m = side_m / most_cells;
  while (cell_m < side_m && copies(cell_m) > most_copies * static_cast<double>(entries.size())) cell_m *= 2.0;
  constexpr core::Seconds one_slot{1.0};
  index_ = DiscIndex{within, cell_m, one_slot, core::Seconds{0.0}, entries};
}

bool TimedZones::confined_at(core::Seconds time) const {
  const auto after = std::ranges::upper_bound(confined_, time, {}, &TimeSpan::from);
  return after != confined_.begin() && time <= std::prev(after)->until;
}

template <class PlaceAt>
bool TimedZones::breaks_rule(TimeSpan during, const PlaceAt& place_at) const {
  const auto breaks_no_go = [&](const Area& area) {
    if (!overlap(area.in_force, during)) return false;
    const TimeSpan inside = common(area.in_force, during);
    return area.polygon.meets(place_at(inside.from), place_at(inside.until));
  };
  if (no_go_.any_near(place_at(during.from), place_at(during.until), breaks_no_go)) return true;
  if (stay_in_.empty()) return false;

  // Between two changes the set of zones in force is constant.
  core::Seconds from = during.from;
  while (true) {
    const auto change = std::ranges::upper_bound(changes_s_, from.count());
    const core::Seconds until =
        change == changes_s_.end() ? during.until : std::min(during.until, core::Seconds{*change});
    const core::Seconds middle = from + 0.5 * (until - from);
    std::vector<const plane::PlanePolygon*> in_force;
    stay_in_.any_near(place_at(from), place_at(until), [&](const Area& area) {
      if (overlap(area.in_force, {middle, middle})) in_force.push_back(&area.polygon);
      return false;
    });
    if (confined_at(middle) && !plane::covered(in_force, place_at(from), place_at(until))) return true;
    if (until >= during.until) return false;
    from = until;
  }
}

bool TimedZones::is_near(TimeSpan during, geo::PlanePoint a, geo::PlanePoint b) const {
  if (!stay_in_.empty()) return true;
  const TimeSpan with_room{during.from - room_.time, during.until + room_.time};
  plane::PlaneBox box{a, a};
  box.include(b);
  const plane::PlaneBox around = box.grown(room_.aside.value);
  return no_go_.any_near(around.low, around.high, [&](const Area& area) {
    return overlap(area.in_force, with_room) && plane::overlap(area.polygon.box(), around);
  });
}

template <class PlaceAt>
bool TimedZones::forbid_during(TimeSpan during, const PlaceAt& place_at) const {
  const geo::PlanePoint a = place_at(during.from);
  const geo::PlanePoint b = place_at(during.until);
  if (!is_near(during, a, b)) return false;
  if (breaks_rule(during, place_at)) return true;
  if (room_.is_none()) return false;

  const double length_m = geo::distance_m(a, b);
  const auto breaks_beside = [&](double x_m, double y_m) {
    return std::ranges::any_of(std::array{room_.time, -room_.time}, [&](core::Seconds later) {
      return breaks_rule({during.from + later, during.until + later}, [&](core::Seconds time) {
        const geo::PlanePoint place = place_at(std::clamp(time - later, during.from, during.until));
        return geo::PlanePoint{place.x_m + x_m, place.y_m + y_m};
      });
    });
  };
  const double aside_m = room_.aside.value;
  if (length_m <= 0.0) {
    return breaks_beside(aside_m, 0.0) || breaks_beside(-aside_m, 0.0) || breaks_beside(0.0, aside_m) ||
           breaks_beside(0.0, -aside_m);
  }
  const double x_m = -aside_m * (b.y_m - a.y_m) / length_m;
  const double y_m = aside_m * (b.x_m - a.x_m) / length_m;
  return breaks_beside(x_m, y_m) || breaks_beside(-x_m, -y_m);
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
  if (room_.is_none()) return closed_times_at(point);
  std::vector<TimeSpan> closed;
  const double aside_m = room_.aside.value;
  for (const auto& [x_m, y_m] :
       {std::pair{0.0, 0.0}, {aside_m, 0.0}, {-aside_m, 0.0}, {0.0, aside_m}, {0.0, -aside_m}}) {
    for (const TimeSpan& span : closed_times_at({point.x_m + x_m, point.y_m + y_m}))
      closed.push_back({span.from - room_.time, span.until + room_.time});
  }
  return joined(std::move(closed));
}

std::vector<TimeSpan> TimedZones::closed_times_at(geo::PlanePoint point) const {
  std::vector<TimeSpan> closed;
  no_go_.any_near(point, point, [&](const Area& area) {
    if (area.polygon.contains(point)) closed.push_back(area.in_force);
    return false;
  });
  std::vector<TimeSpan> inside;
  stay_in_.any_near(point, point, [&](const Area& area) {
    if (area.polygon.contains(point)) inside.push_back(area.in_force);
    return false;
  });
  inside = joined(std::move(inside));
  for (const TimeSpan& confined : confined_) {
    core::Seconds from = confined.from;
    for (const TimeSpan& there : inside) {
      if (there.until < confined.from || there.from > confined.until) continue;
      if (from < there.from) closed.push_back({from, there.from});
      from = std::max(from, there.until);
    }
    if (from < confined.until) closed.push_back({from, confined.until});
  }
  return joined(std::move(closed));
}

}  // namespace floeplan::planning::obstacles
