#include "engine/planning/usable_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::planning {
namespace {

constexpr double farthest_m = 100'000.0;  // a place farther away is another mission
constexpr int most_rings = 400;

bool is_usable(const Sea& sea, geo::PlanePoint point, const TimeSpan& when) {
  return !sea.closed_between(point, point) && !sea.timed_zones().forbid(point, point, when) &&
         !sea.icebergs().touched({point, point, when.from.count(), when.until.count()});
}

}  // namespace

std::optional<geo::LonLat> nearest_usable_place(const Sea& sea, geo::PlanePoint around, core::Seconds when) {
  const double step_m = std::max(sea.safety().cell().value, farthest_m / most_rings);
  std::optional<geo::PlanePoint> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  const auto consider = [&](int ix, int iy) {
    const double distance_m = step_m * std::hypot(ix, iy);
    if (distance_m >= least_m) return;
    const geo::PlanePoint point{around.x_m + step_m * ix, around.y_m + step_m * iy};
    const bool later = when.count() > 0.0;
    const core::Seconds on_the_way =
        later ? core::Metres{distance_m} / sea.through_water() : core::Seconds{0.0};
    if (!is_usable(sea, point, {when, when + on_the_way})) return;
    nearest = point;
    least_m = distance_m;
  };
  // A square ring holds points up to sqrt(2) times its half side away: a later ring may still hold a nearer one.
  for (int ring = 1; ring <= most_rings && ring * step_m < least_m; ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      consider(i, -ring);
      consider(i, ring);
      consider(-ring, i);
      consider(ring, i);
    }
  }
  if (!nearest) return std::nullopt;
  return sea.projection().to_lon_lat(*nearest);
}

}  // namespace floeplan::planning
