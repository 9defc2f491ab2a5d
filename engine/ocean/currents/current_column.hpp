#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ocean {

/// Horizontal currents down one column of water at one time: linear between levels, above the first level as
/// at it, nothing below the last.
/// Threads  const members may be called from several threads at once
class CurrentColumn {
 public:
  /// A column that begins with its highest level with water. `levels`: how many are to come, this one included.
  CurrentColumn(core::Metres depth, const geo::VelocityEn& velocity, std::size_t levels);
  /// The next level with water below those before.
  void add(core::Metres depth, const geo::VelocityEn& velocity);

  /// Mean over the depths from top to bottom, as far down as there is water; the lowest water where that is all
  /// above `top`. A band without thickness gives the current there.
  [[nodiscard]] geo::VelocityEn mean(core::Metres top, core::Metres bottom) const;

 private:
  struct Knot {
    double depth_m;
    double east_m_s;
    double north_m_s;
    double east_m2_s;  // integral from the surface
    double north_m2_s;
  };
  [[nodiscard]] Knot at(double depth_m) const;

  std::vector<Knot> knots_;  // the surface and the levels
};

}  // namespace floeplan::ocean
