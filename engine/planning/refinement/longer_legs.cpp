#include "engine/planning/refinement/longer_legs.hpp"

#include "engine/core/units.hpp"

namespace floeplan::planning::refinement {
namespace {

constexpr core::Metres long_enough{3000.0};
constexpr double share_long_enough = 0.2;

}  // namespace

std::vector<std::size_t> short_legs(const cost::Route& route) {
  const auto& points = route.points;
  std::vector<std::pair<double, std::size_t>> found;
  std::size_t from = 0;  // index of the last fixed point
  for (std::size_t to = 1; to < points.size(); ++to) {
    if (!route.fixed[to] && to + 1 < points.size()) continue;
    const double shortest =
        std::min(long_enough.value, share_long_enough * geo::distance_m(points[from], points[to]));
    for (std::size_t i = from; i < to; ++i) {
      const double length = geo::distance_m(points[i], points[i + 1]);
      if (length < shortest) found.emplace_back(length, i);
    }
    from = to;
  }
  std::ranges::sort(found);
  std::vector<std::size_t> legs;
  for (const auto& [length, i] : found) legs.push_back(i);
  return legs;
}

}  // namespace floeplan::planning::refinement
