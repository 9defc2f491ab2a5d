#pragma once

#include <optional>

#include "engine/core/units.hpp"

namespace floeplan::vehicle {

/// Lift and drag of a glider in units of the dynamic pressure times `area`, by the angle of attack alpha in
/// radians: C_L = lift_slope * alpha, C_D = parasite_drag + induced_drag * alpha^2.
/// Source  of the form and of the defaults: Merckelbach, Berger, Krahmann, Dengler and Carpenter 2019, A
///         dynamic flight model for Slocum gliders, J. Atmos. Oceanic Technol. 36,
///         doi:10.1175/JTECH-D-18-0168.1, with the values of its program gliderflight: parasite drag 0.15;
///         hull lift 3.8 and hull drag 9.7; swept wings of aspect ratio 7 at 43 degrees (lift 3.74) with
///         efficiency 0.8, so induced drag 9.7 + 3.74^2 / (pi * 0.8 * 7) = 10.5
struct Hydrodynamics {
  double parasite_drag{0.15};
  double induced_drag{10.5};
  double lift_slope{7.534};
  double area_m2{0.1};

  friend bool operator==(const Hydrodynamics&, const Hydrodynamics&) = default;
};

/// A straight glide at constant speed; climbs and dives are mirror images.
struct SteadyGlide {
  core::Radians angle_of_attack;
  core::Radians path_angle;  // from the horizontal: pitch plus angle of attack
  core::MetresPerSecond horizontal;
  core::MetresPerSecond vertical;
};

/// Angle of the path if the nose is pitched by `pitch` (positive). Empty if the pitch is too flat for a
/// steady glide: the drag of the angle of attack then grows faster than its lift.
[[nodiscard]] std::optional<core::Radians> glide_path_angle(const Hydrodynamics& hydrodynamics,
                                                            core::Radians pitch);

/// The steady glide of a vehicle whose displacement differs from neutral by `buoyancy`: lift and drag balance
/// the weight of this volume of water. The hull's compression and the trim are left out.
/// Errors  empty if the pitch allows no steady glide
/// Source  Merckelbach, Smeed and Griffiths 2010, Vertical water velocities from underwater gliders, J.
///         Atmos. Oceanic Technol. 27, doi:10.1175/2009JTECHO710.1, the balance of forces in its section 2
[[nodiscard]] std::optional<SteadyGlide> steady_glide(const Hydrodynamics& hydrodynamics, core::Radians pitch,
                                                      core::CubicMetres buoyancy);

}  // namespace floeplan::vehicle
