#include "engine/avoidance/current_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::avoidance {
namespace {

constexpr double depth_scale_m = 50.0;
constexpr double time_scale_s = 6.0 * 3600.0;
constexpr double believable = 5.0;  // standard deviations within which a measurement is accepted

template <std::size_t N>
double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

template <std::size_t N>
std::array<double, N> times(const std::array<std::array<double, N>, N>& matrix,
                            const std::array<double, N>& vector) {
  std::array<double, N> product{};
  for (std::size_t i = 0; i < N; ++i) product[i] = dot(matrix[i], vector);
  return product;
}

bool is_usable(const CurrentBin& bin) {
  return std::isfinite(bin.depth.value) && std::isfinite(bin.velocity.east.value) &&
         std::isfinite(bin.velocity.north.value) && std::isfinite(bin.one_sigma.value) &&
         bin.one_sigma.value > 0.0;
}

}  // namespace

CurrentEstimate::CurrentEstimate(const CarriedForecast& forecast, core::Metres deepest,
                                 core::MetresPerSecond forecast_sigma)
    : forecast_{&forecast},
      spacing_m_{std::max(deepest.value, 1.0) / static_cast<double>(depths - 1)},
      sigma_m_s_{forecast_sigma.value} {
  for (std::size_t i = 0; i < depths; ++i) {
    for (std::size_t j = 0; j < depths; ++j) {
      const double apart_m = spacing_m_ * std::abs(static_cast<double>(i) - static_cast<double>(j));
      prior_[i][j] = sigma_m_s_ * sigma_m_s_ * std::exp(-apart_m / depth_scale_m);
    }
  }
  covariance_ = prior_;
}

void CurrentEstimate::take(const CurrentProfile& profile, geo::PlanePoint place) {
  let_pass(profile.time);
  for (const CurrentBin& bin : profile.bins) {
    if (is_usable(bin)) measure(bin, forecast_->at(place, bin.depth, profile.time));
  }
}

EstimatedCurrent CurrentEstimate::at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const {
  return blended(forecast_->at(place, depth, time), weights_at(depth), time);
}

EstimatedCurrent CurrentEstimate::mean(geo::PlanePoint place, core::Metres top, core::Metres bottom,
                                       core::UtcTime time) const {
  geo::VelocityEn forecast{};
  Weights weights{};
  for (std::size_t i = 0; i < depths; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(depths);
    const core::Metres depth{top.value + share * (bottom.value - top.value)};
    const geo::VelocityEn here = forecast_->at(place, depth, time);
    forecast.east.value += here.east.value / static_cast<double>(depths);
    forecast.north.value += here.north.value / static_cast<double>(depths);
    const Weights of_depth = weights_at(depth);
    for (std::size_t j = 0; j < depths; ++j) weights[j] += of_depth[j] / static_cast<double>(depths);
  }
  return blended(forecast, weights, time);
}

CurrentEstimate::Weights CurrentEstimate::weights_at(core::Metres depth) const {
  const double position = std::clamp(depth.value / spacing_m_, 0.0, static_cast<double>(depths - 1));
  const std::size_t first = std::min(static_cast<std::size_t>(position), depths - 2);
  Weights weights{};
  weights[first + 1] = position - static_cast<double>(first);
  weights[first] = 1.0 - weights[first + 1];
  return weights;
}

EstimatedCurrent CurrentEstimate::blended(geo::VelocityEn forecast, const Weights& weights,
                                          core::UtcTime time) const {
  const double kept = kept_until(time);
  const double variance = kept * kept * dot(weights, times(covariance_, weights)) +
                          (1.0 - kept * kept) * dot(weights, times(prior_, weights));
  return {{{forecast.east.value + kept * dot(weights, east_)},
           {forecast.north.value + kept * dot(weights, north_)}},
          {std::sqrt(std::max(variance, 0.0))}};
}

/// Share of the information from the last measurement that is still valid at this time.
double CurrentEstimate::kept_until(core::UtcTime time) const {
  if (!time_) return 1.0;
  return std::exp(-std::max((time - *time_).count(), 0.0) / time_scale_s);
}

void CurrentEstimate::let_pass(core::UtcTime time) {
  const double kept = kept_until(time);
  for (std::size_t i = 0; i < depths; ++i) {
    east_[i] *= kept;
    north_[i] *= kept;
    for (std::size_t j = 0; j < depths; ++j) {
      covariance_[i][j] = kept * kept * covariance_[i][j] + (1.0 - kept * kept) * prior_[i][j];
    }
  }
  time_ = time;
}

void CurrentEstimate::measure(const CurrentBin& bin, geo::VelocityEn forecast) {
  const Weights weights = weights_at(bin.depth);
  const Weights spread = times(covariance_, weights);
  const double variance = dot(weights, spread) + bin.one_sigma.value * bin.one_sigma.value;
  const double east = bin.velocity.east.value - forecast.east.value - dot(weights, east_);
  const double north = bin.velocity.north.value - forecast.north.value - dot(weights, north_);
  if (std::hypot(east, north) > believable * std::sqrt(2.0 * variance)) return;

  for (std::size_t i = 0; i < depths; ++i) {
    east_[i] += spread[i] / variance * east;
    north_[i] += spread[i] / variance * north;
    for (std::size_t j = 0; j < depths; ++j) covariance_[i][j] -= spread[i] * spread[j] / variance;
  }
}

}  // namespace floeplan::avoidance
