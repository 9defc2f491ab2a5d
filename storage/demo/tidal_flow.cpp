#include "storage/demo/tidal_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace floeplan::demo {
namespace {

constexpr double full_turn_rad = 2.0 * std::numbers::pi;
constexpr double m2_period_s = 12.4206012 * 3600.0;
constexpr double s2_period_s = 12.0 * 3600.0;
constexpr double s2_share = 0.25;
// depths below this count as this, because the tide would be too fast over shoals
constexpr double shallowest_m = 40.0;

}  // namespace

Gate with_inflow(Gate gate, double inflow) {
  gate.inflow = inflow;
  return gate;
}

Flow tidal_flow(const RasterFrame& frame, const std::vector<bool>& land, const std::vector<double>& bed_m,
                const std::vector<Gate>& gates) {
  std::vector<double> resistance(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) resistance[i] = 100.0 / std::max(bed_m[i], shallowest_m);
  Flow flow = stream_flow(frame, land, resistance, gates, std::vector<double>(frame.size()));
  for (std::size_t i = 0; i < frame.size(); ++i) {
    flow.east[i] *= resistance[i];
    flow.north[i] *= resistance[i];
  }
  return flow;
}

void scale_to_speed(Flow& flow, double speed_m_s, double exempt) {
  std::vector<double> speeds;
  for (std::size_t i = 0; i < flow.east.size(); ++i) {
    const double speed = std::hypot(flow.east[i], flow.north[i]);
    if (speed > 0.0) speeds.push_back(speed);
  }
  const auto nth =
      speeds.begin() + static_cast<std::ptrdiff_t>((1.0 - exempt) * static_cast<double>(speeds.size() - 1));
  std::ranges::nth_element(speeds, nth);
  const double factor = speed_m_s / *nth;
  for (std::size_t i = 0; i < flow.east.size(); ++i) {
    const double speed = factor * std::hypot(flow.east[i], flow.north[i]);
    const double held = factor * std::min(1.0, 1.15 * speed_m_s / std::max(speed, 1e-12));
    flow.east[i] *= held;
    flow.north[i] *= held;
  }
}

double springs_and_neaps(core::Seconds since_highest) {
  return (std::cos(full_turn_rad * since_highest.count() / m2_period_s) +
          s2_share * std::cos(full_turn_rad * since_highest.count() / s2_period_s)) /
         (1.0 + s2_share);
}

}  // namespace floeplan::demo
