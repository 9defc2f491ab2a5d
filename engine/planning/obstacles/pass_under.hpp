#pragma once

#include <memory>
#include <optional>

#include "engine/ocean/ice/iceberg.hpp"
#include "engine/planning/obstacles/bed_cells.hpp"
#include "engine/planning/problem/keel.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::obstacles {

/// Whether and where a vehicle may pass under icebergs: all the way across a berg's disc its dives stay below the keel,
/// and it needs as much water from their upper turn to the sea bed as it otherwise needs from the surface, with room
/// for a saw-tooth above the altimeter's margin.
/// Draft    of a berg whose size nobody told, neither length nor draft nor class, nothing is expected: it is never
///          passed under
/// Edges    no bathymetry: every depth will do; where the bed is not known there is no room
/// Threads  const members may be called from several threads at once
class PassUnder {
 public:
  /// `bed`  null: every depth will do
  PassUnder(const IcebergRules& rules, const vehicle::GliderProfile& vehicle,
            std::shared_ptr<const BedCells> bed);

  /// Empty where the rules do not allow it, and where the vehicle does not dive deep enough.
  [[nodiscard]] std::optional<Keel> keel_of(const ocean::Iceberg& iceberg) const;
  /// Whether the sea is deep enough here for dives that turn at this depth.
  [[nodiscard]] bool has_room(geo::PlanePoint point, core::Metres upper_turn) const;
  /// The same all along the straight line from a to b.
  [[nodiscard]] bool has_room_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres upper_turn) const;

 private:
  IcebergRules rules_;
  std::shared_ptr<const BedCells> bed_;  // null: every depth will do
  core::Metres needed_below_;            // from the upper turn to the sea bed
  core::Metres dive_room_;               // from the upper turn to the deepest point of the dives
  core::Metres dive_depth_;
};

}  // namespace floeplan::planning::obstacles
