#include "engine/planning/analytic_currents.hpp"

#include <cmath>

namespace floeplan::planning {

std::optional<motion::CurrentXy> RiverCurrent::operator()(geo::PlanePoint point, core::Seconds) const {
  if (point.x_m < 0.0 || point.x_m > width_m) return std::nullopt;
  return motion::CurrentXy{0.0, 4.0 / (width_m * width_m) * point.x_m * (width_m - point.x_m) * peak_m_s};
}

std::optional<motion::CurrentXy> MeanderingJet::operator()(geo::PlanePoint point, core::Seconds time) const {
  // phi = 1 - tanh(n / sqrt(d)), n = y - B cos(p), d = 1 + k^2 B^2 sin^2(p), p = k (x - c t)
  const double t = time.count();
  const double amplitude = b_0 + epsilon * std::cos(omega * t + theta);
  const double phase = k * (point.x_m - c * t);
  const double cosine = std::cos(phase);
  const double sine = std::sin(phase);
  const double n = point.y_m - amplitude * cosine;
  const double d = 1.0 + k * k * amplitude * amplitude * sine * sine;
  const double root = std::sqrt(d);
  const double steepness = 1.0 / std::cosh(n / root);
  const double sech2 = steepness * steepness;

  const double dn_dx = k * amplitude * sine;
  const double dd_dx = 2.0 * k * k * k * amplitude * amplitude * sine * cosine;
  const double u = sech2 / root;                                            // -d(phi)/dy
  const double v = -sech2 * (dn_dx / root - 0.5 * n * dd_dx / (d * root));  // d(phi)/dx
  return motion::CurrentXy{u, v};
}

}  // namespace floeplan::planning
