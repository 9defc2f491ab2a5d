#pragma once

#include <array>

#include "engine/core/units.hpp"

namespace floeplan::tide {

/// The six angles that every line of the tide is a whole-numbered sum of, in Doodson's order.
/// Units    degrees, not reduced to one turn
struct MeanLongitudes {
  double lunar_time_deg{};     // tau: hour angle of the mean moon, from the lower transit
  double moon_deg{};           // s
  double sun_deg{};            // h
  double lunar_perigee_deg{};  // p
  double lunar_node_deg{};     // N, which goes backwards; Doodson's fifth number counts N' = -N
  double solar_perigee_deg{};  // p'

  /// tau, s, h, p, N', p'.
  [[nodiscard]] std::array<double, 6> in_doodsons_order() const {
    return {lunar_time_deg, moon_deg, sun_deg, lunar_perigee_deg, -lunar_node_deg, solar_perigee_deg};
  }
};

/// Accuracy the time scale is UTC throughout: neglecting its minute to dynamical time turns the moon by 0.01 degrees
/// Source   mean longitudes of Moon, Sun, perigee and node: Meeus 1998, Astronomical algorithms, equations (47.1),
///          (25.2) and (47.7) and chapter 22; perigee of the Sun: Simon and others 1994, Numerical expressions for
///          precession formulae and mean elements for the Moon and the planets, Astron. Astrophys. 282
[[nodiscard]] MeanLongitudes mean_longitudes(core::UtcTime time);

}  // namespace floeplan::tide
