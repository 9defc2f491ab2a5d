#include "engine/geo/united_boxes.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace floeplan::geo {
namespace {

struct Arc {
  double west_deg{};
  double width_deg{};
};

/// Angle eastwards from `from_deg` to `to_deg`, in [0, 360).
double turn(double from_deg, double to_deg) {
  const double difference = longitude_difference(from_deg, to_deg);
  return difference < 0.0 ? difference + 360.0 : difference;
}

}  // namespace

BoundingBox united(std::span<const BoundingBox> boxes) {
  if (boxes.empty()) throw std::invalid_argument{"united needs at least one box"};
  BoundingBox result = boxes.front();
  std::vector<Arc> arcs;
  for (const BoundingBox& box : boxes) {
    result.south_deg = std::min(result.south_deg, box.south_deg);
    result.north_deg = std::max(result.north_deg, box.north_deg);
    arcs.push_back({wrap_longitude(box.west_deg), width_deg(box)});
  }
  std::ranges::sort(arcs, {}, &Arc::west_deg);
  // Degrees count from the beginning of the first arc. An arc that runs past 360 covers the beginning of the
  // first one again, and closes gaps there.
  double reached_deg = 0.0;
  for (const Arc& arc : arcs)
    reached_deg = std::max(reached_deg, arc.west_deg - arcs.front().west_deg + arc.width_deg - 360.0);
  double widest_gap_deg = 0.0;
  for (std::size_t i = 0; i <= arcs.size(); ++i) {
    const bool is_round = i == arcs.size();
    const double begins_deg = is_round ? 360.0 : arcs[i].west_deg - arcs.front().west_deg;
    if (begins_deg - reached_deg > widest_gap_deg) {
      widest_gap_deg = begins_deg - reached_deg;
      result.west_deg = is_round ? arcs.front().west_deg : arcs[i].west_deg;
      result.east_deg = wrap_longitude(arcs.front().west_deg + reached_deg);
    }
    if (!is_round) reached_deg = std::max(reached_deg, begins_deg + arcs[i].width_deg);
  }
  constexpr double rounding_deg = 1e-9;
  if (widest_gap_deg <= rounding_deg) {
    result.west_deg = -180.0;
    result.east_deg = 180.0;
  }
  return result;
}

bool holds(const BoundingBox& outer, const BoundingBox& inner) {
  constexpr double rounding_deg = 1e-9;
  const double begins_deg = width_deg(outer) >= 360.0 ? 0.0 : turn(outer.west_deg, inner.west_deg);
  return inner.south_deg >= outer.south_deg && inner.north_deg <= outer.north_deg &&
         begins_deg + width_deg(inner) <= width_deg(outer) + rounding_deg;
}

double share_held(const BoundingBox& outer, const BoundingBox& inner) {
  if (!intersects(outer, inner)) return 0.0;
  const auto share = [](double held_deg, double all_deg) {
    return all_deg > 0.0 ? std::clamp(held_deg / all_deg, 0.0, 1.0) : 1.0;
  };
  const double inner_width = width_deg(inner);
  // The outer box may begin once between the western edge of the inner box and its end, or already cover that
  // edge.
  const double begins = turn(inner.west_deg, outer.west_deg);
  const double ahead = std::min(inner_width, begins + width_deg(outer)) - std::min(inner_width, begins);
  const double behind = std::min(inner_width, std::max(0.0, begins + width_deg(outer) - 360.0));
  return share(ahead + behind, inner_width) *
         share(std::min(outer.north_deg, inner.north_deg) - std::max(outer.south_deg, inner.south_deg),
               inner.north_deg - inner.south_deg);
}

std::optional<BoundingBox> shared(const BoundingBox& a, const BoundingBox& b) {
  if (!intersects(a, b)) return std::nullopt;
  BoundingBox result{a.west_deg, std::max(a.south_deg, b.south_deg), a.east_deg,
                     std::min(a.north_deg, b.north_deg)};
  const double a_width = width_deg(a);
  if (width_deg(b) >= 360.0) return result;
  if (a_width >= 360.0) return BoundingBox{b.west_deg, result.south_deg, b.east_deg, result.north_deg};
  const double begins = turn(a.west_deg, b.west_deg);
  const bool begins_inside = begins <= a_width;
  const bool ends_inside = turn(a.west_deg, b.east_deg) <= a_width;
  const bool in_two_pieces = begins_inside && ends_inside && begins + width_deg(b) > a_width;
  if (in_two_pieces) return result;
  if (begins_inside) result.west_deg = b.west_deg;
  if (ends_inside) result.east_deg = b.east_deg;
  return result;
}

}  // namespace floeplan::geo
