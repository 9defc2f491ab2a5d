#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/obstacles/iceberg_discs.hpp"

namespace floeplan::planning::obstacles {

/// How often a vehicle meets icebergs where and when, for searches that weigh it: what `IcebergDiscs` expects of a
/// move, read from a lattice.
/// Accuracy  positions count as no better known than a cell of the lattice is wide, and bergs as standing against the
///           vehicle's speed; what a plan states is reckoned without it
/// Threads   const members may be called from several threads at once
class EncounterMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  EncounterMap(const IcebergDiscs& icebergs, const plane::PlaneBox& area, core::Seconds horizon,
               core::MetresPerSecond speed, const std::stop_token& stop);

  /// Expected on the straight way from a to b, which takes `time` from `depart` on.
  [[nodiscard]] double along(geo::PlanePoint a, geo::PlanePoint b, core::Seconds depart,
                             core::Seconds time) const;

 private:
  [[nodiscard]] double rate(geo::PlanePoint point, double t_s) const;
  [[nodiscard]] double rate_in_slot(std::size_t slot, double column, double row) const;

  plane::PlaneBox area_;
  double slot_s_;
  std::size_t slots_;
  std::vector<float> rates_per_s_;  // [slot][y][x], at the nodes
};

}  // namespace floeplan::planning::obstacles
