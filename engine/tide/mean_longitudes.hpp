#pragma once

#include <array>

#include "engine/core/units.hpp"

namespace floeplan::tide {

/// Six angles, in Doodson's order. The argument of every constituent is a sum of them with whole-number
/// factors.
/// Units    degrees, not reduced to one turn
struct MeanLongitudes {
  double lunar_time_deg{};     // tau: hour angle of the mean Moon, from the lower transit
  double moon_deg{};           // s: mean longitude of the Moon
  double sun_deg{};            // h: mean longitude of the Sun
  double lunar_perigee_deg{};  // p: longitude of the lunar perigee
  double lunar_node_deg{};     // N, decreasing; Doodson's fifth number counts N' = -N
  double solar_perigee_deg{};  // p': longitude of the solar perigee

  /// The angles tau, s, h, p, N', p'.
  [[nodiscard]] std::array<double, 6> in_doodsons_order() const {
    return {lunar_time_deg, moon_deg, sun_deg, lunar_perigee_deg, -lunar_node_deg, solar_perigee_deg};
  }
};

/// The six angles at a time.
/// Accuracy UTC is used as time scale: the difference of a minute to dynamical time changes the Moon by 0.01
/// degrees
/// Source   mean longitudes of Moon, Sun, perigee and node: Meeus 1998, Astronomical algorithms, equations
///          (47.1), (25.2) and (47.7) and chapter 22; perigee of the Sun: Simon and others 1994, Numerical
///          expressions for precession formulae and mean elements for the Moon and the planets, Astron.
///          Astrophys. 282
[[nodiscard]] MeanLongitudes mean_longitudes(core::UtcTime time);

}  // namespace floeplan::tide
