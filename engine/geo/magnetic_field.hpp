#pragma once

#include <chrono>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// The Earth's main magnetic field at a place.
/// Frame    local east, north and down of the WGS84 ellipsoid
/// Units    nT
struct MagneticField {
  double east_nt{};
  double north_nt{};
  double down_nt{};
};

/// Angle from true north to magnetic north. East is positive, as in the model and on charts; a Slocum's
/// m_gps_mag_var has the opposite sign (see LocalMissionAxes).
struct Declination {
  double east_deg{};
  double sigma_deg{};  // standard deviation stated by the model; at most 180
};

/// First and last instant of the model's validity.
inline constexpr core::UtcTime first_magnetic_time{
    std::chrono::sys_days{std::chrono::year{2010} / std::chrono::January / 1}};
inline constexpr core::UtcTime last_magnetic_time{
    std::chrono::sys_days{std::chrono::year{2030} / std::chrono::January / 1}};

/// The magnetic field by the edition of the World Magnetic Model that is valid at the time: spherical
/// harmonics to degree 12 with their secular variation. Between two editions it jumps by little more than the
/// declination's sigma.
/// `height`  above the ellipsoid
/// Edges    at the poles east and north are those of the place's longitude
/// Outside  nullopt before and after the model's period; never extrapolates
/// Errors   std::invalid_argument for an invalid place
/// Threads  may be called from several threads at once
/// Source   Chulliat et al. 2025, The US/UK World Magnetic Model for 2025-2030; sums by GeographicLib's
///          SphericalHarmonic1. Agrees with an independent implementation to 0.001 degrees
[[nodiscard]] std::optional<MagneticField> magnetic_field_at(LonLat place, core::UtcTime time,
                                                             core::Metres height = {});

/// Declination of the magnetic field at the ellipsoid; otherwise as magnetic_field_at.
[[nodiscard]] std::optional<Declination> declination_at(LonLat place, core::UtcTime time);

}  // namespace floeplan::geo
