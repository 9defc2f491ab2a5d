#include "engine/planning/search/usable_place.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace floeplan::planning::search {
namespace {

constexpr double farthest_m = farthest_usable_place.value;
constexpr int most_rings = 400;

bool is_usable(const cost::PlanningDomain& domain, geo::PlanePoint point) {
  return !domain.closures().closed_between(point, point) &&
         !domain.closures().timed_zones().forbid(point, point, {}) &&
         !domain.icebergs().touched({point, point, 0.0, 0.0});
}

/// Nodes of a square lattice around a place.
class Lattice {
 public:
  Lattice(geo::PlanePoint middle, double step_m, int steps)
      : middle_{middle}, step_m_{step_m}, steps_{steps} {}

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(side() * side()); }
  [[nodiscard]] geo::PlanePoint point(std::size_t node) const {
    return {middle_.x_m + step_m_ * static_cast<double>(column(node) - steps_),
            middle_.y_m + step_m_ * static_cast<double>(row(node) - steps_)};
  }
  /// Calls `visit(node)` for the nodes next to a node, or next to a place of the plane.
  template <class Visit>
  void for_each_beside(std::size_t node, const Visit& visit) const {
    for_each_about(column(node), row(node), visit);
  }
  template <class Visit>
  void for_each_about(geo::PlanePoint place, const Visit& visit) const {
    for_each_about(index((place.x_m - middle_.x_m) / step_m_), index((place.y_m - middle_.y_m) / step_m_),
                   visit);
  }

 private:
  [[nodiscard]] std::int64_t side() const { return 2 * steps_ + 1; }
  [[nodiscard]] std::int64_t column(std::size_t node) const {
    return static_cast<std::int64_t>(node) % side();
  }
  [[nodiscard]] std::int64_t row(std::size_t node) const { return static_cast<std::int64_t>(node) / side(); }
  [[nodiscard]] std::int64_t index(double steps_off) const {
    return steps_ + std::lround(std::clamp(steps_off, -2.0 * steps_, 2.0 * steps_));
  }
  template <class Visit>
  void for_each_about(std::int64_t column, std::int64_t row, const Visit& visit) const {
    for (std::int64_t y = std::max<std::int64_t>(0, row - 1); y <= std::min(side() - 1, row + 1); ++y)
      for (std::int64_t x = std::max<std::int64_t>(0, column - 1); x <= std::min(side() - 1, column + 1); ++x)
        visit(static_cast<std::size_t>(y * side() + x));
  }

  geo::PlanePoint middle_;
  double step_m_;
  int steps_;
};

}  // namespace

std::optional<geo::LonLat> nearest_usable_place(const cost::PlanningDomain& domain, geo::PlanePoint around) {
  const double step_m = std::max(domain.safety().cell().value, farthest_m / most_rings);
  std::optional<geo::PlanePoint> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  const auto consider = [&](int ix, int iy) {
    const double distance_m = step_m * std::hypot(ix, iy);
    if (distance_m >= least_m) return;
    const geo::PlanePoint point{around.x_m + step_m * ix, around.y_m + step_m * iy};
    if (!is_usable(domain, point)) return;
    nearest = point;
    least_m = distance_m;
  };
  // A square ring reaches from its half side to sqrt(2) times that: a later ring may still hold a nearer
  // place.
  for (int ring = 1; ring <= most_rings && ring * step_m < least_m; ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      consider(i, -ring);
      consider(i, ring);
      consider(-ring, i);
      consider(ring, i);
    }
  }
  if (!nearest) return std::nullopt;
  return domain.projection().to_lon_lat(*nearest);
}

std::optional<geo::LonLat> nearest_usable_place_towards(const cost::PlanningDomain& domain,
                                                        geo::PlanePoint around, geo::PlanePoint other,
                                                        const std::stop_token& stop) {
  constexpr std::size_t between_checks = 1024;  // between checks of the stop token
  const double reach_m = std::max(farthest_m, geo::distance_m(around, other));
  const Lattice lattice{around, std::max(domain.safety().cell().value, reach_m / most_rings), most_rings};
  std::vector<bool> seen(lattice.size());
  std::vector<std::size_t> joined;  // nodes that open water connects with `other`
  const auto join_from = [&](geo::PlanePoint from) {
    return [&, from](std::size_t node) {
      if (seen[node] || domain.closures().closed_between(from, lattice.point(node))) return;
      seen[node] = true;
      joined.push_back(node);
    };
  };
  lattice.for_each_about(other, join_from(other));
  std::optional<geo::PlanePoint> nearest;
  for (std::size_t next = 0; next < joined.size(); ++next) {
    if (next % between_checks == 0 && stop.stop_requested()) return std::nullopt;
    const geo::PlanePoint here = lattice.point(joined[next]);
    lattice.for_each_beside(joined[next], join_from(here));
    const double distance_m = geo::distance_m(around, here);
    if (distance_m > farthest_m || (nearest && distance_m >= geo::distance_m(around, *nearest))) continue;
    if (is_usable(domain, here)) nearest = here;
  }
  if (!nearest) return std::nullopt;
  return domain.projection().to_lon_lat(*nearest);
}

}  // namespace floeplan::planning::search
