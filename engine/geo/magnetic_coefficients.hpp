#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace floeplan::geo {

inline constexpr int magnetic_degree = 12;
inline constexpr std::size_t magnetic_terms = 90;  // degrees 1 to 12, each with orders 0 to its degree

/// A pair of Gauss coefficients in Schmidt semi-normalisation.
struct MagneticCoefficient {
  int n;         // degree
  int m;         // order
  double g_nt;   // cosine coefficient at the epoch, nT
  double h_nt;   // sine coefficient at the epoch, nT
  double dg_nt;  // change of g, nT per year
  double dh_nt;
};

/// One edition of the World Magnetic Model, valid for five years from its epoch.
struct MagneticEpoch {
  double year;
  /// The standard deviation of the declination is sqrt(sigma_deg^2 + (sigma_nt / H)^2) degrees; H: horizontal
  /// field in nT.
  double sigma_deg;
  double sigma_nt;
  std::array<MagneticCoefficient, magnetic_terms> terms;
};

/// WMM2010, WMM2015v2, WMM2020 and WMM2025, oldest first, with all published digits.
/// Source   coefficients: NOAA National Centers for Environmental Information and British Geological Survey,
///          World Magnetic Model, files WMM.COF; works of the US Government, in the public domain. Errors:
///          the editions' technical reports, section on model uncertainty. The report of 2010 gives no
///          formula, so the largest of the later ones is used
[[nodiscard]] std::span<const MagneticEpoch> magnetic_epochs();

}  // namespace floeplan::geo
