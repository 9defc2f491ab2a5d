#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace floeplan::geo {

inline constexpr int magnetic_degree = 12;
inline constexpr std::size_t magnetic_terms = 90;  // degrees 1 to 12, each with its orders 0 to n

/// A pair of Gauss coefficients, semi-normalised after Schmidt.
struct MagneticCoefficient {
  int n;         // degree
  int m;         // order
  double g_nt;   // of the cosine, at the epoch
  double h_nt;   // of the sine
  double dg_nt;  // change of g each year
  double dh_nt;
};

/// One edition of the World Magnetic Model, which holds for five years from its epoch.
struct MagneticEpoch {
  double year;
  /// One standard deviation of its declination is sqrt(sigma_deg^2 + (sigma_nt / H)^2) degrees, H the horizontal field.
  double sigma_deg;
  double sigma_nt;
  std::array<MagneticCoefficient, magnetic_terms> terms;
};

/// WMM2010, WMM2015v2, WMM2020 and WMM2025, oldest first, to the digits that were published.
/// Source   coefficients: NOAA National Centers for Environmental Information and British Geological Survey, World
///          Magnetic Model, files WMM.COF; works of the US Government, in the public domain.
///          Errors: the editions' technical reports, section on model uncertainty. That of 2010 gives no formula; the
///          widest of the later ones stands in for it
[[nodiscard]] std::span<const MagneticEpoch> magnetic_epochs();

}  // namespace floeplan::geo
