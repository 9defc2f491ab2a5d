#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/planning/cost/route.hpp"

namespace floeplan::planning::refinement {

/// Shifts of a route's free points as a sum of hat functions. The coarsest hat bends a whole section between two
/// fixed points, the finest moves one point. Gradient descent over hats takes about as many steps for many points as for
/// few, because the second derivative of a line's length is diagonal in them.
/// Source  Yserentant 1986, On the multi-level splitting of finite element spaces, Numer. Math. 49,
///         doi:10.1007/BF01389538 (hierarchical basis; exactly orthogonal in one dimension)
class HatBasis {
 public:
  /// One hat: its peak, and the points on both sides at which it falls to zero.
  struct Hat {
    std::size_t left{};
    std::size_t peak{};
    std::size_t right{};
    double left_share{};  // share of the left point's own shift that the peak takes over
    double right_share{};
    double unit{};  // shift in metres at which the second derivative of the travel time is about one second
  };

  explicit HatBasis(const cost::Itinerary& timed);

  /// Coarse hats come before the finer ones on their slopes.
  [[nodiscard]] const std::vector<Hat>& hats() const { return hats_; }

  /// Shift of every point of the route in metres, from one coefficient per hat; zero at fixed points.
  [[nodiscard]] std::vector<double> shifts(std::span<const double> coefficients) const;
  /// Derivatives with respect to the coefficients, from the derivatives with respect to the shifts of the points.
  void derive(std::vector<double> by_shift, std::span<double> by_coefficient) const;

 private:
  std::size_t points_;
  std::vector<Hat> hats_;
};

}  // namespace floeplan::planning::refinement
