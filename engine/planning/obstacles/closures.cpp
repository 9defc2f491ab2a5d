#include "engine/planning/obstacles/closures.hpp"

#include <algorithm>
#include <utility>

namespace floeplan::planning::obstacles {

std::optional<core::Seconds> Closures::first_clear_departure(geo::PlanePoint a, geo::PlanePoint b,
                                                             core::Seconds duration, core::Seconds depart,
                                                             core::Seconds latest) const {
  constexpr core::Seconds first_step{60.0};  // to the next departure if a zone forbids the leg; then doubled
  constexpr core::Seconds longest_step{900.0};
  constexpr core::Seconds close_enough{5.0};
  const auto forbidden = [&](core::Seconds leaves) {
    return timed_zones_.forbid(a, b, {leaves, leaves + duration});
  };
  while (depart <= latest) {
    if (!icebergs_.standing()) {
      const auto clear = icebergs_.first_clear(a, b, duration, depart, latest);
      if (!clear) return std::nullopt;
      depart = *clear;
    }
    if (!forbidden(depart)) return depart;
    core::Seconds closed = depart;
    core::Seconds open = depart + first_step;
    for (core::Seconds step = first_step; forbidden(open);) {
      if (open > latest) return std::nullopt;
      step = std::min(2.0 * step, longest_step);
      closed = open;
      open += step;
    }
    while (open - closed > close_enough) {
      const core::Seconds middle = 0.5 * (closed + open);
      (forbidden(middle) ? closed : open) = middle;
    }
    depart = open;
  }
  return std::nullopt;
}

std::vector<TimeSpan> Closures::closed_times(geo::PlanePoint point) const {
  std::vector<TimeSpan> closed = closed_times_by_zones(point);
  const std::vector<TimeSpan> by_icebergs = closed_times_by_icebergs(point);
  closed.insert(closed.end(), by_icebergs.begin(), by_icebergs.end());
  return joined(std::move(closed));
}

}  // namespace floeplan::planning::obstacles
