#include "engine/planning/obstacles/drifting_disc.hpp"

#include <cmath>

namespace floeplan::planning::obstacles {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr std::size_t knots_in_a_block = 12;  // half a day of a forecast with hourly steps

plane::PlaneBox box_around(const DriftingDisc::Knot& knot) {
  return plane::PlaneBox{knot.centre, knot.centre}.grown(knot.radius_m);
}

/// The move in reversed time.
motion::EvenMove reversed(const motion::EvenMove& move) {
  return {move.to, move.from, -move.t1_s, -move.t0_s};
}

motion::MovingDisc reversed(const motion::MovingDisc& disc) {
  const double duration = disc.t1_s - disc.t0_s;
  return {
      -disc.t1_s,
      -disc.t0_s,
      {disc.centre0.x_m + duration * disc.velocity.x_m_s, disc.centre0.y_m + duration * disc.velocity.y_m_s},
      {-disc.velocity.x_m_s, -disc.velocity.y_m_s},
      disc.radius0_m + duration * disc.growth_m_s,
      -disc.growth_m_s};
}

/// Whether a move is far from all that the disc covers between two knots. The test uses one axis at a time,
/// without root or division, so it is quick.
bool is_far(const motion::EvenMove& move, const DriftingDisc::Knot& a, const DriftingDisc::Knot& b,
            double slack_m) {
  const double radius_m = std::max(a.radius_m, b.radius_m) + slack_m;
  const auto apart = [&](double from, double to, double centre, double next) {
    return std::abs(from - centre) > radius_m + std::abs(to - from) + std::abs(next - centre);
  };
  return apart(move.from.x_m, move.to.x_m, a.centre.x_m, b.centre.x_m) ||
         apart(move.from.y_m, move.to.y_m, a.centre.y_m, b.centre.y_m);
}

}  // namespace

std::optional<TimeSpan> time_within(const motion::MovingDisc& disc, const motion::EvenMove& move) {
  const auto first = motion::first_touch(move, disc);
  if (!first) return std::nullopt;
  motion::MovingDisc ending = disc;
  ending.t1_s = std::min(disc.t1_s, move.t1_s);
  if (ending.t1_s == endless) return TimeSpan{core::Seconds{*first}, core::Seconds{endless}};
  const auto last = motion::first_touch(reversed(move), reversed(ending));
  return TimeSpan{core::Seconds{*first}, core::Seconds{last ? -*last : *first}};
}

DriftingDisc::DriftingDisc(const std::vector<TrackPoint>& track, core::Metres hull, core::Metres margin,
                           core::Metres rounding)
    : hull_m_{hull.value},
      kept_m_{track.front().scale * (hull.value + margin.value)},
      swept_{track.front().centre, track.front().centre} {
  for (const TrackPoint& point : track) {
    scales_.push_back(point.scale);
    knots_.push_back({point.t_s, point.centre,
                      point.scale * (hull.value + margin.value + point.error.value + rounding.value)});
    swept_.include(box_around(knots_.back()));
  }
  for (std::size_t first = 0; first < knots_.size(); first += knots_in_a_block) {
    blocks_.push_back(swept_from(first));
    const std::size_t next = std::min(first + knots_in_a_block, knots_.size());
    for (std::size_t knot = first + 1; knot < next; ++knot) blocks_.back().include(swept_from(knot));
  }
}

plane::PlaneBox DriftingDisc::swept_from(std::size_t knot) const {
  plane::PlaneBox box = box_around(knots_[knot]);
  if (knot + 1 < knots_.size()) box.include(box_around(knots_[knot + 1]));
  return box;
}

motion::MovingDisc DriftingDisc::piece(std::size_t knot) const {
  const Knot& a = knots_[knot];
  if (knot + 1 == knots_.size()) return {a.t_s, endless, a.centre, {}, a.radius_m, 0.0};
  const Knot& b = knots_[knot + 1];
  const double duration = b.t_s - a.t_s;
  return {a.t_s,      b.t_s,
          a.centre,   {(b.centre.x_m - a.centre.x_m) / duration, (b.centre.y_m - a.centre.y_m) / duration},
          a.radius_m, (b.radius_m - a.radius_m) / duration};
}

std::optional<double> DriftingDisc::first_touch(const motion::EvenMove& move, double slack_m) const {
  for (std::size_t knot = last_knot_by(move.t0_s); knot < knots_.size() && knots_[knot].t_s <= move.t1_s;
       ++knot) {
    if (is_far(move, knots_[knot], knots_[std::min(knot + 1, knots_.size() - 1)], slack_m)) continue;
    motion::MovingDisc disc = piece(knot);
    disc.radius0_m += slack_m;
    if (const auto first = motion::first_touch(move, disc)) return first;
  }
  return std::nullopt;
}

std::optional<double> DriftingDisc::gap_m(geo::PlanePoint point, double t_s) const {
  std::optional<double> gap_m;
  for_each_piece(t_s, t_s, [&](const motion::MovingDisc& disc) {
    const double since_s = t_s - disc.t0_s;
    gap_m = std::hypot(point.x_m - disc.centre0.x_m - since_s * disc.velocity.x_m_s,
                       point.y_m - disc.centre0.y_m - since_s * disc.velocity.y_m_s) -
            disc.radius0_m - since_s * disc.growth_m_s;
    return true;
  });
  return gap_m;
}

std::optional<TimeSpan> DriftingDisc::covers_from(std::size_t knot, geo::PlanePoint point,
                                                  double slack_m) const {
  const auto is_inside = [&](const Knot& at) {
    const double x_m = point.x_m - at.centre.x_m;
    const double y_m = point.y_m - at.centre.y_m;
    const double radius_m = at.radius_m + slack_m;
    return x_m * x_m + y_m * y_m <= radius_m * radius_m;
  };
  const Knot& from = knots_[knot];
  const bool lasts = knot + 1 == knots_.size();
  const Knot& to = lasts ? from : knots_[knot + 1];
  // Distance minus radius is convex in time: a point that is inside at both ends is inside all the time.
  if (is_inside(from) && is_inside(to))
    return TimeSpan{core::Seconds{from.t_s}, core::Seconds{lasts ? endless : to.t_s}};
  const motion::EvenMove stay{point, point, from.t_s, lasts ? endless : to.t_s};
  if (is_far(stay, from, to, slack_m)) return std::nullopt;
  motion::MovingDisc grown = piece(knot);
  grown.radius0_m += slack_m;
  return time_within(grown, stay);
}

std::vector<TimeSpan> DriftingDisc::covers(geo::PlanePoint point, double slack_m) const {
  std::vector<TimeSpan> covered;
  if (!swept_.grown(slack_m).contains(point)) return covered;
  for (std::size_t knot = 0; knot < knots_.size(); ++knot) {
    if (knot % knots_in_a_block == 0 && !blocks_[knot / knots_in_a_block].grown(slack_m).contains(point)) {
      knot += knots_in_a_block - 1;
      continue;
    }
    const auto span = covers_from(knot, point, slack_m);
    if (!span) continue;
    // If the disc covers the point at a knot, the spans before and after it join.
    if (!covered.empty() && span->from <= covered.back().until) {
      covered.back().until = std::max(covered.back().until, span->until);
    } else {
      covered.push_back(*span);
    }
  }
  return covered;
}

}  // namespace floeplan::planning::obstacles
