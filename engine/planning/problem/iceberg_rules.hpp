#pragma once

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// How the planner keeps clear of icebergs.
struct IcebergRules {
  core::Metres margin{500.0};  // kept to the edge of an iceberg, in addition to the position error
  bool drift{true};            // false: each berg stays where it was seen; its position error stays, too
  /// The most by which the position error widens the disc that routes keep out of. Without a limit the discs would
  /// close the whole sea within a day. The plan states the risk of a larger error as expected encounters.
  core::Metres max_inflation{5000.0};

  /// Weight of one expected encounter in the objective, as seconds of travel. With zero the plan states
  /// encounters but does not avoid them.
  core::Seconds encounter_weight{0.0};
  /// Whether the vehicle may pass under icebergs of known size whose keels end above its dives. Inside the disc of such
  /// an iceberg its dives turn below the keel, and it must not come to the surface.
  bool pass_under{false};
  /// Vertical distance between the deepest keel and the upper turn. Default: twice what the vehicles keep
  /// above the sea bed, because turns overshoot by metres and a keel is not flat.
  core::Metres keel_clearance{20.0};
  /// Share added to every draft. Default: our own choice. The published relations of draft to length state no
  /// scatter; for one length they differ by a factor of up to 1.6, and the deepest of them is used already.
  double draft_uncertainty{0.25};

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
  friend bool operator==(const IcebergRules&, const IcebergRules&) = default;
};

}  // namespace floeplan::planning
