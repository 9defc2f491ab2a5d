#pragma once

#include <cstddef>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ocean {

/// Horizontal currents in one column of water at one time. Linear between levels; above the first level the
/// value of that level; no current below the last.
/// Threads  const members may be called from several threads at once
class CurrentColumn {
 public:
  /// A column that begins with its uppermost level with water. `levels`: total number of levels that will be
  /// added.
  CurrentColumn(core::Metres depth, const geo::VelocityEn& velocity, std::size_t levels);
  /// Adds the next lower level with water.
  void add(core::Metres depth, const geo::VelocityEn& velocity);

  /// Mean over the depths from top to bottom, as far down as there is water. If all water is above `top`, the
  /// current of the lowest level. If top equals bottom, the current there.
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

  std::vector<Knot> knots_;  // the surface and all levels
};

}  // namespace floeplan::ocean
