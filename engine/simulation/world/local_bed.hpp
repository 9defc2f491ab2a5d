#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// The sea bed about a vehicle on a grid of 5 m: a ping asks for it thousands of times, and on a grid the answer is
/// quick and its steepest slope is known.
/// Frame    that of the world; nodes lie at whole multiples of the spacing, so that the bed is the same wherever the
///          grid was laid from; bilinear between them
/// Memory   laid anew when the vehicle has moved 100 m; in between no member allocates
/// Threads  one instance for each flight
class LocalBed {
 public:
  static constexpr double spacing_m = 5.0;

  /// `world` is borrowed. `reach` is how far from the vehicle the bed is asked for.
  LocalBed(const World& world, core::Metres reach);

  void look_from(Vector place);

  /// Positive down; empty where it is not known. Precondition: within reach of the place looked from.
  [[nodiscard]] std::optional<double> depth_m(double east_m, double north_m) const;
  /// Depth of the shallowest node of the grid; empty where nothing is known.
  [[nodiscard]] std::optional<double> shallowest_m() const { return shallowest_m_; }
  /// Never less than the slope of the bed anywhere on the grid, metres of depth by metres of way.
  [[nodiscard]] double steepest() const { return steepest_; }

 private:
  void lay(Vector about);
  void measure();

  const World& world_;
  double reach_m_;
  std::size_t side_;  // nodes
  Vector laid_about_{};
  double west_m_{};
  double south_m_{};
  std::vector<float> depths_;  // [north][east]; not a number: not known
  std::optional<double> shallowest_m_{};
  double steepest_{};
};

}  // namespace floeplan::simulation
