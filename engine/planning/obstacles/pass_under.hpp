#pragma once

#include <memory>
#include <optional>

#include "engine/ocean/ice/iceberg.hpp"
#include "engine/planning/obstacles/bed_cells.hpp"
#include "engine/planning/problem/keel.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::obstacles {

/// Whether and where a vehicle may pass under icebergs. Everywhere in a berg's disc its dives stay below the
/// keel. From their upper turn to the sea bed it needs as much water as it otherwise needs from the surface,
/// with room for a saw-tooth above the altimeter's margin.
/// Draft    a berg of unknown size (no length, draft or class) is never passed under
/// Edges    without bathymetry every depth counts as deep enough; where the bed is unknown there is no room
/// Threads  const members may be called from several threads at once
class PassUnder {
 public:
  /// `bed`  depths of the sea bed; null: every depth counts as deep enough
  PassUnder(const IcebergRules& rules, const vehicle::GliderProfile& vehicle,
            std::shared_ptr<const BedCells> bed);

  /// The keel and the upper turn below it. Empty if the rules do not allow to pass under the berg, or if the
  /// vehicle cannot dive deep enough.
  [[nodiscard]] std::optional<Keel> keel_of(const ocean::Iceberg& iceberg) const;
  /// Whether the sea at `point` is deep enough for dives whose upper turn is at `upper_turn`.
  [[nodiscard]] bool has_room(geo::PlanePoint point, core::Metres upper_turn) const;
  /// Whether the sea is deep enough for dives whose upper turn is at `upper_turn`, all along the straight
  /// line from `a` to `b`.
  [[nodiscard]] bool has_room_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres upper_turn) const;

 private:
  IcebergRules rules_;
  std::shared_ptr<const BedCells> bed_;  // null: every depth is enough
  core::Metres needed_below_;            // from the upper turn to the sea bed
  core::Metres dive_room_;               // from the upper turn to the deepest point of the dives
  core::Metres dive_depth_;
};

}  // namespace floeplan::planning::obstacles
