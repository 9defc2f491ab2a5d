#pragma once

#include <cstddef>
#include <vector>

#include "engine/planning/currents/plane_currents.hpp"

namespace floeplan::planning::currents {

/// Between which values the components of the current lie in the neighbourhood of a point, at whatever hour.
/// Accuracy encloses all that the currents answer there; where they answer nothing, as much as anywhere
/// Threads  const members may be called from several threads at once
class CurrentEnvelope {
 public:
  /// Along the axes of the plane.
  struct Box {
    float low_x_m_s{};
    float high_x_m_s{};
    float low_y_m_s{};
    float high_y_m_s{};

    /// The most of it that sets in a direction, given by its unit vector.
    [[nodiscard]] core::MetresPerSecond most_along(geo::PlanePoint direction) const;
  };

  /// `currents` is borrowed and outlives this. `reach`: of the neighbourhood, in metres of the plane.
  CurrentEnvelope(const PlaneCurrents& currents, core::Metres reach);

  [[nodiscard]] Box about(geo::PlanePoint point) const;

 private:
  [[nodiscard]] std::vector<Box> boxes_of_nodes() const;

  const PlaneCurrents& currents_;
  Box anywhere_;
  std::vector<Box> boxes_;  // of each cell of the data, [y][x]; none where nothing can be told of places
};

}  // namespace floeplan::planning::currents
