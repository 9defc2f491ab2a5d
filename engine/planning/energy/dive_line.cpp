#include "engine/planning/energy/dive_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::energy {
namespace {

/// The mean of 1/x between two positive values of x. It keeps its accuracy where they are nearly equal.
double mean_inverse(double a, double b) {
  constexpr double nearly_the_same = 0.05;
  const double off = (b - a) / (a + b);
  // ln(b / a) = 2 atanh(off), by its series. The terms left out are below 1e-11 of the result.
  if (std::abs(off) < nearly_the_same) {
    const double square = off * off;
    return 2.0 * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square / 7.0))) / (a + b);
  }
  return std::log(b / a) / (b - a);
}

double between(double a, double b, double share) { return a + share * (b - a); }

}  // namespace

DiveLine::DiveLine(const vehicle::DiveLimits& limits, const obstacles::PlaneBed* bed, core::Metres look,
                   geo::PlanePoint a, geo::PlanePoint b)
    : top_{limits.climb_to} {
  const core::Metres shoalest = top_ + vehicle::lowest_tooth;
  const core::Metres deepest = std::max(limits.dive_to, shoalest);
  // The depth at which the sea bed alone would turn the dives.
  const auto turn = [&](double share) {
    const auto depth = bed != nullptr ? bed->depth(plane::place_between(a, b, share)) : std::nullopt;
    return depth ? *depth - limits.altimeter_margin : deepest;
  };
  const auto flown = [&](core::Metres asked) { return std::clamp(asked, shoalest, deepest); };
  if (bed == nullptr || a == b) {
    stretches_.push_back({1.0, flown(turn(0.0)), flown(turn(0.0))});
    return;
  }
  double from = 0.0;
  core::Metres first = turn(0.0);
  for (const double until : bed->bends(a, b, look)) {
    if (bed->is_stepped()) {
      const core::Metres all_along = flown(turn(0.5 * (from + until)));
      add_stretch({until, all_along, all_along});
    } else {
      const core::Metres last = turn(until);
      add_bend(from, until, {first, turn(0.5 * (from + until)), last}, {shoalest, deepest});
      first = last;
    }
    from = until;
  }
  const core::Metres bottom = stretches_.front().first_bottom;
  const bool even = std::ranges::all_of(
      stretches_, [&](const Stretch& s) { return s.first_bottom == bottom && s.last_bottom == bottom; });
  if (even) stretches_ = {{1.0, bottom, bottom}};
}

void DiveLine::add_bend(double from, double until, const Bend& bend, const Bounds& bounds) {
  constexpr double near_enough = 0.005;  // share of the thickness of the dives
  constexpr double most_parts = 16.0;
  const core::Metres off_straight = bend.middle - 0.5 * (bend.first + bend.last);
  const core::Metres lowest =
      std::max(std::min({bend.first, bend.middle, bend.last}), bounds.shoalest) - top_;
  const double parts =
      std::clamp(std::ceil(std::sqrt(std::abs(off_straight / lowest) / near_enough)), 1.0, most_parts);
  const auto at = [&](double t) {
    return bend.first + t * (bend.last - bend.first) + 4.0 * t * (1.0 - t) * off_straight;
  };
  for (double i = 0.0; i < parts; ++i) {
    const double begins = i / parts;
    const double ends = (i + 1.0) / parts;
    add_slope(between(from, until, begins), between(from, until, ends), at(begins), at(ends), bounds);
  }
}

void DiveLine::add_slope(double from, double until, core::Metres first, core::Metres last,
                         const Bounds& bounds) {
  const auto flown = [&](core::Metres turn) { return std::clamp(turn, bounds.shoalest, bounds.deepest); };
  double kinks[] = {(bounds.shoalest - first) / (last - first), (bounds.deepest - first) / (last - first)};
  if (kinks[0] > kinks[1]) std::swap(kinks[0], kinks[1]);
  core::Metres begins = flown(first);
  for (const double kink : kinks) {
    if (!(kink > 0.0 && kink < 1.0)) continue;
    const core::Metres ends = flown(first + kink * (last - first));
    add_stretch({between(from, until, kink), begins, ends});
    begins = ends;
  }
  add_stretch({until, begins, flown(last)});
}

void DiveLine::add_stretch(const Stretch& stretch) {
  const double begins = stretches_.empty() ? 0.0 : stretches_.back().until;
  if (stretch.until > begins) stretches_.push_back(stretch);
}

double DiveLine::turns_m(const Stretch& stretch, double from, double until, core::Metres upper_turn) const {
  const core::Metres first = vehicle::band_below(upper_turn, {top_, stretch.first_bottom}).thickness();
  const core::Metres last = vehicle::band_below(upper_turn, {top_, stretch.last_bottom}).thickness();
  return mean_inverse(between(first.value, last.value, from), between(first.value, last.value, until));
}

vehicle::DiveBand DiveLine::mean_band(double from, double until, core::Metres upper_turn) const {
  auto stretch = std::ranges::lower_bound(stretches_, from, {}, &Stretch::until);
  double begins = stretch == stretches_.begin() ? 0.0 : std::prev(stretch)->until;
  double turns = 0.0;  // for each metre of depth, times the share of the line
  double looked_at = from;
  do {
    const double length = stretch->until - begins;
    const double leaves = std::min(until, stretch->until);
    const double here =
        turns_m(*stretch, (looked_at - begins) / length, (leaves - begins) / length, upper_turn);
    turns += (until > from ? leaves - looked_at : 1.0) * here;
    looked_at = begins = stretch->until;
    ++stretch;
  } while (looked_at < until && stretch != stretches_.end());
  if (until > from) turns /= until - from;
  const core::Metres top = std::max(top_, upper_turn);
  return {top, top + core::Metres{1.0 / turns}};
}

}  // namespace floeplan::planning::energy
