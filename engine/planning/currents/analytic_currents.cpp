#include "engine/planning/currents/analytic_currents.hpp"

#include <cmath>

namespace floeplan::planning::currents {
namespace {

/// The argument q = n / sqrt(d) of the jet's stream function phi = 1 - tanh(q), and its derivatives, where n
/// = y - B cos(p), d = 1 + k^2 B^2 sin^2(p), p = k (x - c t). The second derivative along y is zero.
struct JetArgument {
  double q;
  double x;
  double y;
  double xx;
  double xy;
};

JetArgument jet_argument(const MeanderingJet& jet, geo::PlanePoint point, double t) {
  const double k = jet.k;
  const double amplitude = jet.b_0 + jet.epsilon * std::cos(jet.omega * t + jet.theta);
  const double phase = k * (point.x_m - jet.c * t);
  const double cosine = std::cos(phase);
  const double sine = std::sin(phase);
  const double ka2 = k * k * amplitude * amplitude;

  const double n = point.y_m - amplitude * cosine;
  const double n_x = k * amplitude * sine;
  const double n_xx = k * k * amplitude * cosine;
  const double d = 1.0 + ka2 * sine * sine;
  const double d_x = 2.0 * k * ka2 * sine * cosine;
  const double d_xx = 2.0 * k * k * ka2 * (cosine * cosine - sine * sine);

  const double y = 1.0 / std::sqrt(d);
  return {.q = n * y,
          .x = y * (n_x - 0.5 * n * d_x / d),
          .y = y,
          .xx = y * (n_xx - (n_x * d_x + 0.5 * n * d_xx) / d + 0.75 * n * d_x * d_x / (d * d)),
          .xy = -0.5 * y * d_x / d};
}

}  // namespace

std::optional<motion::CurrentXy> RiverCurrent::operator()(geo::PlanePoint point, core::Seconds) const {
  if (point.x_m < 0.0 || point.x_m > width_m) return std::nullopt;
  return motion::CurrentXy{0.0, 4.0 / (width_m * width_m) * point.x_m * (width_m - point.x_m) * peak_m_s};
}

std::optional<motion::SlopedCurrent> RiverCurrent::slopes_at(geo::PlanePoint point, core::Seconds) const {
  const double x = point.x_m;
  if (std::abs(x - 0.5 * width_m) > 0.51 * width_m) return std::nullopt;
  const double steepness = 4.0 / (width_m * width_m) * peak_m_s;
  return motion::SlopedCurrent{.velocity = {0.0, steepness * x * (width_m - x)},
                               .dy_dx = steepness * (width_m - 2.0 * x)};
}

std::optional<motion::CurrentXy> MeanderingJet::operator()(geo::PlanePoint point, core::Seconds time) const {
  const JetArgument q = jet_argument(*this, point, time.count());
  const double steepness = 1.0 / std::cosh(q.q);
  const double sech2 = steepness * steepness;
  return motion::CurrentXy{sech2 * q.y, -sech2 * q.x};
}

std::optional<motion::SlopedCurrent> MeanderingJet::slopes_at(geo::PlanePoint point,
                                                              core::Seconds time) const {
  const JetArgument q = jet_argument(*this, point, time.count());
  const double steepness = 1.0 / std::cosh(q.q);
  const double sech2 = steepness * steepness;
  const double bend = 2.0 * std::tanh(q.q);  // the slope of sech^2 is -sech^2 times this
  const double mixed = sech2 * (q.xy - bend * q.x * q.y);
  return motion::SlopedCurrent{.velocity = {sech2 * q.y, -sech2 * q.x},
                               .dx_dx = mixed,
                               .dx_dy = -sech2 * bend * q.y * q.y,
                               .dy_dx = -sech2 * (q.xx - bend * q.x * q.x),
                               .dy_dy = -mixed};
}

}  // namespace floeplan::planning::currents
