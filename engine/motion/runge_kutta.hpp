#pragma once

#include <algorithm>
#include <cmath>
#include <tl/expected.hpp>

#include "engine/motion/edge_closed.hpp"

namespace floeplan::motion {

/// A step from s to s + h in which t grows by `gain`, as a cubic through both ends with the slopes there.
struct StepCubic {
  double h{};
  double gain{};
  double k_start{};
  double k_end{};

  /// Growth of t over this share of the step.
  [[nodiscard]] double gain_at(double share) const {
    const double from = h * k_start;
    const double to = h * k_end;
    return share * (from + share * (3.0 * gain - 2.0 * from - to + share * (from + to - 2.0 * gain)));
  }

  /// Derivative of `gain_at`, per whole step.
  [[nodiscard]] double slope_at(double share) const {
    const double from = h * k_start;
    const double to = h * k_end;
    return from + share * (2.0 * (3.0 * gain - 2.0 * from - to) + share * 3.0 * (from + to - 2.0 * gain));
  }
};

/// The share of a step at which t has grown by `wanted`. Precondition: 0 <= wanted <= gain.
inline double share_with_gain(const StepCubic& step, double wanted) {
  double low = 0.0;
  double high = 1.0;
  double share = wanted / step.gain;
  for (int i = 0; i < 60; ++i) {
    const double miss = wanted - step.gain_at(share);
    (miss > 0.0 ? low : high) = share;
    const double guess = share + miss / step.slope_at(share);  // Newton's step; bisection if it fails
    const double next = guess > low && guess < high ? guess : 0.5 * (low + high);
    if (std::abs(next - share) <= 1e-13) break;
    share = next;
  }
  return share;
}

// Steps by embedded pairs of Runge-Kutta formulas for dt/ds = k(s, t). `gain` comes from the higher formula,
// `error` estimates that of the lower one. `is_its_cubic`: the cubic is as accurate as the formula, so a step
// may be cut short anywhere. The function k takes (s, t) and returns tl::expected<double, EdgeClosed>.

/// A 3(2) pair, and Simpson's rule along its cubic: four new values of k per step. Their difference is the
/// error of the third-order formula. The pair's own estimate is that of the second order, ten times too
/// large. A share of it is kept as a guard for the case that the other two agree by chance.
/// Source   Bogacki and Shampine 1989, A 3(2) pair of Runge-Kutta formulas, Appl. Math. Lett. 2,
///          doi:10.1016/0893-9659(89)90079-7; between its ends the cubic through values and slopes
struct BogackiShampine : StepCubic {
  double error{};
  static constexpr bool is_its_cubic = true;
  static constexpr double share_for_a_step = 1.0;  // of the tolerance
  static constexpr double pair_share = 0.2;        // of the pair's estimate, kept as a guard

  template <class K>
  static tl::expected<BogackiShampine, EdgeClosed> step(const K& k, double s, double t, double h, double k1) {
    const auto k2 = k(s + 0.5 * h, t + 0.5 * h * k1);
    if (!k2) return tl::unexpected(k2.error());
    const auto k3 = k(s + 0.75 * h, t + 0.75 * h * *k2);
    if (!k3) return tl::unexpected(k3.error());
    const double gain = h * (2.0 / 9.0 * k1 + 1.0 / 3.0 * *k2 + 4.0 / 9.0 * *k3);
    const auto k4 = k(s + h, t + gain);
    if (!k4) return tl::unexpected(k4.error());
    const double of_pair =
        h * std::abs(5.0 / 72.0 * k1 - 1.0 / 12.0 * *k2 - 1.0 / 9.0 * *k3 + 1.0 / 8.0 * *k4);
    const auto middle = k(s + 0.5 * h, t + StepCubic{h, gain, k1, *k4}.gain_at(0.5));
    if (!middle) return tl::unexpected(middle.error());
    const double by_simpson = h / 6.0 * (k1 + 4.0 * *middle + *k4);
    const double error = std::max(std::abs(by_simpson - gain), pair_share * of_pair);
    return BogackiShampine{{h, by_simpson, k1, *k4}, error};
  }

  /// Factor of the step length that multiplies the error per second by `ratio`.
  static double lengthening(double ratio) { return std::cbrt(ratio); }
};

/// A 5(4) pair: six new values of k per step, worth it for tight tolerances.
/// Source   Dormand and Prince 1980, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6,
///          doi:10.1016/0771-050X(80)90013-3
struct DormandPrince : StepCubic {
  double error{};
  static constexpr bool is_its_cubic = false;
  static constexpr double share_for_a_step = 0.1;  // its estimate is too small for long steps

  template <class K>
  static tl::expected<DormandPrince, EdgeClosed> step(const K& k, double s, double t, double h, double k1) {
    const auto k2 = k(s + h / 5.0, t + h / 5.0 * k1);
    if (!k2) return tl::unexpected(k2.error());
    const auto k3 = k(s + 0.3 * h, t + h * (3.0 / 40.0 * k1 + 9.0 / 40.0 * *k2));
    if (!k3) return tl::unexpected(k3.error());
    const auto k4 = k(s + 0.8 * h, t + h * (44.0 / 45.0 * k1 - 56.0 / 15.0 * *k2 + 32.0 / 9.0 * *k3));
    if (!k4) return tl::unexpected(k4.error());
    const auto k5 = k(s + 8.0 / 9.0 * h, t + h * (19372.0 / 6561.0 * k1 - 25360.0 / 2187.0 * *k2 +
                                                  64448.0 / 6561.0 * *k3 - 212.0 / 729.0 * *k4));
    if (!k5) return tl::unexpected(k5.error());
    const auto k6 = k(s + h, t + h * (9017.0 / 3168.0 * k1 - 355.0 / 33.0 * *k2 + 46732.0 / 5247.0 * *k3 +
                                      49.0 / 176.0 * *k4 - 5103.0 / 18656.0 * *k5));
    if (!k6) return tl::unexpected(k6.error());
    const double gain = h * (35.0 / 384.0 * k1 + 500.0 / 1113.0 * *k3 + 125.0 / 192.0 * *k4 -
                             2187.0 / 6784.0 * *k5 + 11.0 / 84.0 * *k6);
    const auto k7 = k(s + h, t + gain);
    if (!k7) return tl::unexpected(k7.error());
    const double error = h * std::abs(71.0 / 57600.0 * k1 - 71.0 / 16695.0 * *k3 + 71.0 / 1920.0 * *k4 -
                                      17253.0 / 339200.0 * *k5 + 22.0 / 525.0 * *k6 - 1.0 / 40.0 * *k7);
    return DormandPrince{{h, gain, k1, *k7}, error};
  }

  static double lengthening(double ratio) { return std::sqrt(std::sqrt(ratio)); }
};

}  // namespace floeplan::motion
