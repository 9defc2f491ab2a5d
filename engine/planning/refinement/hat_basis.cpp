#include "engine/planning/refinement/hat_basis.hpp"

#include <cmath>
#include <utility>

namespace floeplan::planning::refinement {
namespace {

/// Cumulative sum of length squared over time of the legs before each point, in m^2/s. It measures how far points may
/// be shifted across the route for a second of delay. Legs without length count with a very small value.
std::vector<double> give_along(const cost::Itinerary& timed) {
  constexpr double trifle_m2_s = 1e-9;
  const auto& points = timed.route.points;
  std::vector<double> give{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double leg_m = geo::distance_m(points[i - 1], points[i]);
    const double time_s = (timed.times[i] - timed.times[i - 1]).count();
    give.push_back(give.back() + trifle_m2_s + (time_s > 0.0 ? leg_m * leg_m / time_s : 0.0));
  }
  return give;
}

}  // namespace

HatBasis::HatBasis(const cost::Itinerary& timed) : points_{timed.route.points.size()} {
  const std::vector<double> give = give_along(timed);
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  for (std::size_t left = 0, i = 1; i < points_; ++i) {
    if (!timed.route.fixed[i]) continue;
    spans.emplace_back(left, i);
    left = i;
  }
  for (std::size_t s = 0; s < spans.size(); ++s) {
    const auto [left, right] = spans[s];
    if (right - left < 2) continue;
    const std::size_t peak = left + (right - left) / 2;
    const double before = give[peak] - give[left];
    const double after = give[right] - give[peak];
    // A shift y across the route lengthens it by y^2 / 2 (1 / before + 1 / after).
    const double unit = std::sqrt(before * after / (before + after));
    hats_.push_back({left, peak, right, after / (before + after), before / (before + after), unit});
    spans.emplace_back(left, peak);
    spans.emplace_back(peak, right);
  }
}

std::vector<double> HatBasis::shifts(std::span<const double> coefficients) const {
  std::vector<double> result(points_, 0.0);
  for (std::size_t k = 0; k < hats_.size(); ++k) {
    const Hat& hat = hats_[k];
    result[hat.peak] =
        hat.left_share * result[hat.left] + hat.right_share * result[hat.right] + hat.unit * coefficients[k];
  }
  return result;
}

void HatBasis::derive(std::vector<double> by_shift, std::span<double> by_coefficient) const {
  for (std::size_t k = hats_.size(); k-- > 0;) {
    const Hat& hat = hats_[k];
    by_coefficient[k] = hat.unit * by_shift[hat.peak];
    by_shift[hat.left] += hat.left_share * by_shift[hat.peak];
    by_shift[hat.right] += hat.right_share * by_shift[hat.peak];
  }
}

}  // namespace floeplan::planning::refinement
