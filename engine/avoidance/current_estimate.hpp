#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/avoidance/carried_forecast.hpp"
#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"

namespace floeplan::avoidance {

/// A current and how sure of it one is.
struct EstimatedCurrent {
  geo::VelocityEn velocity{};
  core::MetresPerSecond one_sigma{};  // of either component

  friend bool operator==(const EstimatedCurrent&, const EstimatedCurrent&) = default;
};

/// The sea current around the vehicle: the carried forecast and what ADCP profiles say of its error.
/// Filter   Kalman's, one for east and one for north with the same covariance, on the forecast's error at evenly
///          spaced depths. Before any measurement the error is a Gaussian process of the stated sigma whose correlation
///          falls as exp(-|dz| / 50 m) in depth and exp(-|dt| / 6 h) in time: half the vertical scale of a summer
///          thermocline's shear, and a quarter of the inertial and tidal periods that forecasts miss in phase. A bin
///          between two of the depths is a measurement of the linear mean of both
/// Memory   fixed; no member allocates
/// Source   Kalman 1960, doi:10.1115/1.3662552; the prior in time is the Ornstein-Uhlenbeck process
class CurrentEstimate {
 public:
  /// `deepest`: the depths run from the surface to there. `forecast` is borrowed.
  CurrentEstimate(const CarriedForecast& forecast, core::Metres deepest,
                  core::MetresPerSecond forecast_sigma);

  /// Takes what the ADCP measured around `place`. A bin that is not finite, or whose sigma is not above zero, or that
  /// lies more than five sigma from what is believed, is left out.
  void take(const CurrentProfile& profile, geo::PlanePoint place);

  [[nodiscard]] EstimatedCurrent at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const;
  /// Mean over the depths from `top` to `bottom`, as a steady saw-tooth meets them.
  [[nodiscard]] EstimatedCurrent mean(geo::PlanePoint place, core::Metres top, core::Metres bottom,
                                      core::UtcTime time) const;

 private:
  static constexpr std::size_t depths = 12;
  using Weights = std::array<double, depths>;  // of a linear mean of the errors at the depths
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
