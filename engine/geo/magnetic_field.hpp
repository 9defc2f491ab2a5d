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

/// Angle of magnetic north from true north. East is positive, as the model and charts have it; a Slocum's
/// m_gps_mag_var has the other sign (see LocalMissionAxes).
struct Declination {
  double east_deg{};
  double sigma_deg{};  // one standard deviation, as the model states it; 180 at most
};

/// First and last instant of the model.
inline constexpr core::UtcTime first_magnetic_time{
    std::chrono::sys_days{std::chrono::year{2010} / std::chrono::January / 1}};
inline constexpr core::UtcTime last_magnetic_time{
    std::chrono::sys_days{std::chrono::year{2030} / std::chrono::January / 1}};

/// The World Magnetic Model of the edition that holds at the time: spherical harmonics to degree 12 with their secular
/// variation. Between two editions it steps, by little more than the declination's sigma anywhere.
/// `height`  above the ellipsoid
/// Edges    at the poles east and north are those of the place's longitude
/// Outside  nullopt before and after the model's times; never extrapolates
/// Errors   std::invalid_argument for a place that is none
/// Threads  may be called from several threads at once
/// Source   Chulliat et al. 2025, The US/UK World Magnetic Model for 2025-2030; sums by GeographicLib's
///          SphericalHarmonic1. Agrees with an independent implementation to 0.001 degrees
[[nodiscard]] std::optional<MagneticField> magnetic_field_at(LonLat place, core::UtcTime time,
                                                             core::Metres height = {});

/// The field's declination; otherwise as magnetic_field_at.
[[nodiscard]] std::optional<Declination> declination_at(LonLat place, core::UtcTime time);

}  // namespace floeplan::geo
