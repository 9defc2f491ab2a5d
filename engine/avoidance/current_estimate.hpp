#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/avoidance/carried_forecast.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// A current and its uncertainty.
struct EstimatedCurrent {
  geo::VelocityEn velocity{};
  core::MetresPerSecond one_sigma{};  // standard deviation of each component

  friend bool operator==(const EstimatedCurrent&, const EstimatedCurrent&) = default;
};

/// The current around the vehicle: the carried forecast, corrected by ADCP profiles.
/// Filter   A Kalman filter for the forecast's error at equally spaced depths, one for east and one for north
///          with the same covariance. Before any measurement the error is a Gaussian process with the given
///          sigma. Its correlation falls as exp(-|dz| / 50 m) in depth and exp(-|dt| / 6 h) in time: half the
///          vertical scale of a summer thermocline's shear, and a quarter of the inertial and tidal periods
///          whose phase forecasts miss. A bin between two of the depths is a measurement of the linear mean
///          of both
/// Memory   fixed; no member allocates
/// Source   Kalman 1960, doi:10.1115/1.3662552; the prior in time is the Ornstein-Uhlenbeck process
class CurrentEstimate {
 public:
  /// `deepest`: the depths of the filter range from the surface to this. `forecast` is borrowed.
  CurrentEstimate(const CarriedForecast& forecast, core::Metres deepest,
                  core::MetresPerSecond forecast_sigma);

  /// Uses an ADCP profile measured around `place`. A bin is skipped if it is not finite, if its sigma is not
  /// positive, or if it deviates by more than five sigma from the estimate.
  void take(const CurrentProfile& profile, geo::PlanePoint place);

  [[nodiscard]] EstimatedCurrent at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const;
  /// Mean current over the depths from `top` to `bottom`, as a steady saw-tooth meets it.
  [[nodiscard]] EstimatedCurrent mean(geo::PlanePoint place, core::Metres top, core::Metres bottom,
                                      core::UtcTime time) const;

 private:
  static constexpr std::size_t depths = 12;
  using Weights = std::array<double, depths>;  // weights of a linear mean of the errors at the depths
  using Covariance = std::array<std::array<double, depths>, depths>;

  [[nodiscard]] Weights weights_at(core::Metres depth) const;
  [[nodiscard]] EstimatedCurrent blended(geo::VelocityEn forecast, const Weights& weights,
                                         core::UtcTime time) const;
  [[nodiscard]] double kept_until(core::UtcTime time) const;
  void let_pass(core::UtcTime time);
  void measure(const CurrentBin& bin, geo::VelocityEn forecast);

  const CarriedForecast* forecast_;
  double spacing_m_;
  double sigma_m_s_;
  Covariance prior_{};
  Covariance covariance_{};
  Weights east_{};
  Weights north_{};
  std::optional<core::UtcTime> time_{};
};

}  // namespace floeplan::avoidance
