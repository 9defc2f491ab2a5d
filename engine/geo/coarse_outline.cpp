#include "engine/geo/coarse_outline.hpp"

#include <cmath>
#include <cstdint>

namespace floeplan::geo {
namespace {

/// Longer edges could be taken for the other way round the globe.
constexpr double longest_edge_deg = 90.0;
/// Corners outside the box by only a rounding error count as inside.
constexpr double rounding_deg = 1e-9;

/// Computes on which sides of a box places lie: one bit per side, no bit for a place inside.
class Sides {
 public:
  explicit Sides(const BoundingBox& box)
      : box_{box},
        half_width_deg_{0.5 * width_deg(box) + rounding_deg},
        middle_deg_{wrap_longitude(box.west_deg + 0.5 * width_deg(box))} {}

  [[nodiscard]] std::uint8_t of(LonLat place) const {
    std::uint8_t sides = 0;
    if (place.lat_deg < box_.south_deg - rounding_deg) sides |= 1U;
    if (place.lat_deg > box_.north_deg + rounding_deg) sides |= 2U;
    const double from_middle_deg = longitude_difference(middle_deg_, place.lon_deg);
    if (from_middle_deg < -half_width_deg_) sides |= 4U;
    if (from_middle_deg > half_width_deg_) sides |= 8U;
    return sides;
  }

 private:
  BoundingBox box_;
  double half_width_deg_;
  double middle_deg_;
};

Ring coarse_beyond(const Sides& sides, const Ring& ring) {
  if (ring.empty()) return {};
  Ring result{ring.front()};
  std::uint8_t shared = sides.of(ring.front());  // sides on which all corners since the last kept one lie
  double from_kept_deg = 0.0;                    // along the outline to the current corner
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const LonLat& here = ring[i];
    const LonLat& next = ring[(i + 1) % ring.size()];
    from_kept_deg += longitude_difference(ring[i - 1].lon_deg, here.lon_deg);
    const double to_next_deg = from_kept_deg + longitude_difference(here.lon_deg, next.lon_deg);
    const std::uint8_t own = sides.of(here);
    shared &= own;
    if ((shared & sides.of(next)) != 0 && std::abs(to_next_deg) <= longest_edge_deg) continue;
    result.push_back(here);
    shared = own;
    from_kept_deg = 0.0;
  }
  return result;
}

}  // namespace

Polygon coarse_beyond(const BoundingBox& box, const Polygon& polygon) {
  const Sides sides{box};
  Polygon result{.outer = coarse_beyond(sides, polygon.outer), .holes = {}};
  for (const Ring& hole : polygon.holes) {
    Ring coarse = coarse_beyond(sides, hole);
    if (coarse.size() > 2) result.holes.push_back(std::move(coarse));
  }
  return result;
}

}  // namespace floeplan::geo
