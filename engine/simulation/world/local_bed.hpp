#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/simulation/world/space.hpp"
#include "engine/simulation/world/world.hpp"

namespace floeplan::simulation {

/// The sea bed around a vehicle on a grid of 5 m. A ping needs the depth thousands of times: on a grid the
/// answer is quick, and the steepest slope is known.
/// Frame    that of the world; nodes lie at multiples of the spacing, so the bed does not depend on where the
///          grid was made; bilinear between nodes
/// Memory   made again when the vehicle has moved 100 m; between, no member allocates
/// Threads  one instance for each flight
class LocalBed {
 public:
  static constexpr double spacing_m = 5.0;

  /// `world` is borrowed. `reach`: largest distance from the vehicle at which the bed will be asked for.
  LocalBed(const World& world, core::Metres reach);

  void look_from(Vector place);

  /// Depth, positive down; empty if unknown. Precondition: within `reach` of the vehicle's place.
  [[nodiscard]] std::optional<double> depth_m(double east_m, double north_m) const;
  /// Depth of the shallowest node of the grid; empty if no depth is known.
  [[nodiscard]] std::optional<double> shallowest_m() const { return shallowest_m_; }
  /// Upper bound of the bed's slope on the grid, in metres of depth per metre of distance.
  [[nodiscard]] double steepest() const { return steepest_; }

 private:
  void lay(Vector about);
  void measure();

  const World& world_;
  double reach_m_;
  std::size_t side_;  // number of nodes on each side
  Vector laid_about_{};
  double west_m_{};
  double south_m_{};
  std::vector<float> depths_;  // [north][east]; NaN: unknown
  std::optional<double> shallowest_m_{};
  double steepest_{};
};

}  // namespace floeplan::simulation
