#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/ocean/grids/point_velocities.hpp"

namespace floeplan::ocean {

/// The fixed depths to which currents on terrain-following levels are interpolated: the standard levels of
/// the World Ocean Atlas down to the first one below `deepest_m`.
/// Source  Locarnini et al. 2019, World Ocean Atlas 2018 volume 1, table 2 (102 levels from 0 to 5500 m)
[[nodiscard]] std::vector<double> standard_depths_m(double deepest_m);

/// Interpolates currents on terrain-following levels to fixed depths, for every point separately. Linear
/// between levels; the uppermost level counts up to the surface, the lowest down to the bed; missing below
/// the bed. Only two levels and the result are in memory. With `Components::one` each point has one
/// component: it is stored as east, and north stays empty.
class LevelColumns {
 public:
  enum class Components { both, one };

  /// `depths_m`  ascending; borrowed and must outlive this
  LevelColumns(std::span<const double> depths_m, std::size_t points,
               Components components = Components::both);

  /// Adds the next lower level. `level_m`: its depth at every point, NaN over land.
  void add(PointVelocities level, std::vector<float> level_m);
  /// Call after the last level; at least one was added. `bed_m`: the depth of the sea bed at every point.
  /// Returns  the currents at each of the fixed depths
  [[nodiscard]] std::vector<PointVelocities> down_to(std::span<const float> bed_m) &&;

 private:
  /// Fills the depths of one point down to `lower_m`. `share_of_lower(depth)`: weight of the lower level.
  template <class Share>
  void fill(std::size_t point, double lower_m, const PointVelocities& upper, const PointVelocities& lower,
            const Share& share_of_lower);

  std::span<const double> depths_m_;
  std::vector<std::uint16_t> next_;  // for each point: the first depth that is not yet filled
  std::vector<PointVelocities> filled_;
  PointVelocities above_;
  std::vector<float> above_m_;
};

}  // namespace floeplan::ocean
