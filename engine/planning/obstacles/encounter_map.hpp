#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/obstacles/iceberg_discs.hpp"

namespace floeplan::planning::obstacles {

/// Expected encounters with icebergs by place and time, for searches that weigh them: as
/// `IcebergDiscs::expected_encounters`, but interpolated in a precomputed lattice, which is quick.
/// Accuracy  position errors count as at least a cell of the lattice, and bergs as standing compared with the
///           vehicle. The figures in a plan are computed without the lattice
/// Threads   const members may be called from several threads at once
class EncounterMap {
 public:
  /// Once `stop` is requested the map stays incomplete and must not be used.
  EncounterMap(const IcebergDiscs& icebergs, const plane::PlaneBox& area, core::Seconds horizon,
               core::MetresPerSecond speed, const std::stop_token& stop);

  /// Expected number of encounters on the straight line from a to b, travelled in `time` from `depart` on.
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
