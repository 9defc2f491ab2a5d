#pragma once

#include <complex>

namespace floeplan::tide {

/// The ellipse that the tip of a tidal current's vector describes, for one constituent.
/// Units    speeds in m/s (or the unit of the constants), angles in degrees
/// Source   Foreman 1978, Manual for tidal currents analysis and prediction, Pacific Marine Science Report
///          78-6
struct Ellipse {
  double major{};            // semi-major axis, never negative
  double minor{};            // semi-minor axis; negative: the current rotates clockwise
  double inclination_deg{};  // of the northern semi-major axis, counter-clockwise from east, in [0, 180)
  double phase_deg{};        // Greenwich phase lag of the maximum along that axis, in [0, 360)
};

/// Harmonic constants A exp(-i g) of the east and north components.
struct CurrentConstants {
  std::complex<double> east;
  std::complex<double> north;
};

[[nodiscard]] Ellipse ellipse_of(const CurrentConstants& constants);
[[nodiscard]] CurrentConstants constants_of(const Ellipse& ellipse);

}  // namespace floeplan::tide
