#include "engine/planning/plane/plane_polygon.hpp"

#include <algorithm>
#include <limits>

#include "engine/planning/plane/coast_lines.hpp"
#include "engine/planning/plane/plane_lines.hpp"

namespace floeplan::planning::plane {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

PlanePolygon::PlanePolygon(const geo::Polygon& polygon, const geo::LocalProjection& projection)
    : box_{{infinite, infinite}, {-infinite, -infinite}} {
  const auto add = [&](geo::PlanePoint a, geo::PlanePoint b) {
    lines_.push_back({a, b});
    box_.include(a);
    box_.include(b);
  };
  if (polygon.outer.empty()) return;
  for_each_coast_line(polygon.outer, projection, add);
  for (const geo::Ring& hole : polygon.holes) for_each_coast_line(hole, projection, add);
}

bool PlanePolygon::contains(geo::PlanePoint point) const {
  if (!box_.contains(point)) return false;
  // Even-odd rule along the line from the point in the x direction. Two edges that share a corner put it on
  // the same side of this line, so the corner counts once.
  bool inside = false;
  for (const Line& line : lines_) {
    if ((line.from.y_m > point.y_m) == (line.to.y_m > point.y_m)) continue;
    const double share = (point.y_m - line.from.y_m) / (line.to.y_m - line.from.y_m);
    if (place_between(line.from, line.to, share).x_m > point.x_m) inside = !inside;
  }
  return inside;
}

bool PlanePolygon::meets(geo::PlanePoint a, geo::PlanePoint b) const {
  PlaneBox reach{a, a};
  reach.include(b);
  const bool apart = reach.high.x_m < box_.low.x_m || reach.low.x_m > box_.high.x_m ||
                     reach.high.y_m < box_.low.y_m || reach.low.y_m > box_.high.y_m;
  return !apart && (contains(a) || !crossings(a, b).empty());
}

std::vector<double> PlanePolygon::crossings(geo::PlanePoint a, geo::PlanePoint b) const {
  std::vector<double> shares;
  for (const Line& line : lines_) {
    if (const auto share = crossing(a, b, line.from, line.to)) shares.push_back(*share);
  }
  return shares;
}

bool covered(const std::vector<const PlanePolygon*>& polygons, geo::PlanePoint a, geo::PlanePoint b) {
  // Between two crossings with outlines the line stays inside the same polygons, so its middle decides.
  std::vector<double> shares{0.0, 1.0};
  for (const PlanePolygon* polygon : polygons) {
    const std::vector<double> more = polygon->crossings(a, b);
    shares.insert(shares.end(), more.begin(), more.end());
  }
  std::ranges::sort(shares);
  const double length_m = geo::distance_m(a, b);
  for (std::size_t i = 1; i < shares.size(); ++i) {
    if (i > 1 && shares[i] <= shares[i - 1]) continue;
    const bool is_between_two = i > 1 && i + 1 < shares.size();
    if (is_between_two && (shares[i] - shares[i - 1]) * length_m <= touching_m) continue;
    const geo::PlanePoint middle = place_between(a, b, 0.5 * (shares[i - 1] + shares[i]));
    const auto holds = [&](const PlanePolygon* polygon) { return polygon->contains(middle); };
    if (std::ranges::none_of(polygons, holds)) return false;
  }
  return true;
}

}  // namespace floeplan::planning::plane
