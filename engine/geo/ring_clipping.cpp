#include "engine/geo/ring_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geo/ring_turns.hpp"

namespace floeplan::geo {
namespace {

/// The part of a ring on one side of a line. `inside_by(place)`: signed distance from the line, linear in
/// longitude and latitude.
template <class InsideBy>
Ring on_one_side(const Ring& ring, const InsideBy& inside_by) {
  if (std::ranges::all_of(ring, [&](LonLat place) { return inside_by(place) >= 0.0; })) return ring;
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LonLat& from = ring[i];
    const LonLat& to = ring[(i + 1) % ring.size()];
    const double from_deg = inside_by(from);
    const double to_deg = inside_by(to);
    if (from_deg >= 0.0) result.push_back(from);
    if ((from_deg >= 0.0) == (to_deg >= 0.0)) continue;
    const double share = from_deg / (from_deg - to_deg);
    result.push_back(
        {std::lerp(from.lon_deg, to.lon_deg, share), std::lerp(from.lat_deg, to.lat_deg, share)});
  }
  return result;
}

}  // namespace

std::vector<Ring> clipped(const Ring& ring, const GlobeWindow& window) {
  if (ring.empty()) return {};
  Ring between = on_one_side(counted_on(ring, window.middle_lon_deg),
                             [&](LonLat place) { return place.lat_deg - window.south_deg; });
  between = on_one_side(between, [&](LonLat place) { return window.north_deg - place.lat_deg; });
  if (between.empty()) return {};
  if (std::isinf(window.half_width_deg)) return {std::move(between)};

  const auto [west, east] = std::ranges::minmax(between, {}, &LonLat::lon_deg);
  const double low_deg = window.middle_lon_deg - window.half_width_deg;
  const double high_deg = window.middle_lon_deg + window.half_width_deg;
  const auto first = static_cast<int>(std::ceil((low_deg - east.lon_deg) / 360.0));
  const auto last = static_cast<int>(std::floor((high_deg - west.lon_deg) / 360.0));
  std::vector<Ring> result;
  for (int turn = first; turn <= last; ++turn) {
    Ring turned = between;
    for (LonLat& place : turned) place.lon_deg += 360.0 * turn;
    turned = on_one_side(turned, [&](LonLat place) { return place.lon_deg - low_deg; });
    turned = on_one_side(turned, [&](LonLat place) { return high_deg - place.lon_deg; });
    if (!turned.empty()) result.push_back(std::move(turned));
  }
  return result;
}

}  // namespace floeplan::geo
