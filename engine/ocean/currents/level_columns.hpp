#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/ocean/grids/point_velocities.hpp"

namespace floeplan::ocean {

/// Depths at which plans use currents whose levels follow the sea bed: the standard levels of the World Ocean Atlas
/// down to the first one below `deepest_m`.
/// Source  Locarnini et al. 2019, World Ocean Atlas 2018 volume 1, table 2 (102 levels from 0 to 5500 m)
[[nodiscard]] std::vector<double> standard_depths_m(double deepest_m);

/// Brings currents on levels that follow the sea bed to fixed depths, at every point by itself: linear between the
/// levels, the uppermost level up to the surface, the lowest down to the bed, missing below it. Holds two levels and
/// the result at a time. Where each point has one component alone, it is taken for east, and north stays empty.
class LevelColumns {
 public:
  enum class Components { both, one };

  /// `depths_m`  ascending; borrowed, and outlives this
  LevelColumns(std::span<const double> depths_m, std::size_t points,
               Components components = Components::both);

  /// The next level downwards. `level_m`: its depth at every point, NaN over land.
  void add(PointVelocities level, std::vector<float> level_m);
  /// After the last level, of which there is one at least. `bed_m`: the depth of the sea bed at every point.
  /// Returns  the currents at each depth
  [[nodiscard]] std::vector<PointVelocities> down_to(std::span<const float> bed_m) &&;

 private:
  /// Depths of one point down to `lower_m`; `share_of_lower` of a depth gives the weight of the lower level.
  template <class Share>
  void fill(std::size_t point, double lower_m, const PointVelocities& upper, const PointVelocities& lower,
            const Share& share_of_lower);

  std::span<const double> depths_m_;
  std::vector<std::uint16_t> next_;  // the first depth not yet filled, of each point
  std::vector<PointVelocities> filled_;
  PointVelocities above_;
  std::vector<float> above_m_;
};

}  // namespace floeplan::ocean
