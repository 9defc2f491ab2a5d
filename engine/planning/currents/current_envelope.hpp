#pragma once

#include <cstddef>
#include <vector>

#include "engine/planning/currents/plane_currents.hpp"

namespace floeplan::planning::currents {

/// Bounds of the current's components in the neighbourhood of a point, over all times.
/// Accuracy encloses all currents there; where currents are unknown, the bounds of the whole area
/// Threads  const members may be called from several threads at once
class CurrentEnvelope {
 public:
  /// Bounds of the components along the axes of the plane, in m/s.
  struct Box {
    float low_x_m_s{};
    float high_x_m_s{};
    float low_y_m_s{};
    float high_y_m_s{};

    /// The largest component in the direction of this unit vector.
    [[nodiscard]] core::MetresPerSecond most_along(geo::PlanePoint direction) const;
  };

  /// `currents` is borrowed and must outlive this. `reach`: radius of the neighbourhood, in metres of the
  /// plane.
  CurrentEnvelope(const PlaneCurrents& currents, core::Metres reach);

  [[nodiscard]] Box about(geo::PlanePoint point) const;

 private:
  [[nodiscard]] std::vector<Box> boxes_of_nodes() const;

  const PlaneCurrents& currents_;
  Box anywhere_;
  std::vector<Box> boxes_;  // for each cell of the data, [y][x]; empty if places cannot be told apart
};

}  // namespace floeplan::planning::currents
