#pragma once

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// How far the planner trusts what is known of icebergs.
struct IcebergRules {
  core::Metres margin{500.0};  // kept from the edge of an iceberg, beside the error of its position
  bool drift{true};            // false: each berg stays where it was seen and its position ages no further
  /// The most by which the error of a position widens the disc to keep out of; what goes beyond is a risk that
  /// the plan states, because within a day it would close the whole sea.
  core::Metres max_inflation{5000.0};

  /// Seconds of travel that one expected encounter counts as in the objective. Zero: encounters are stated, not
  /// avoided.
  core::Seconds encounter_weight{0.0};
  /// Whether the vehicle may pass under icebergs of known size whose keels end above its dives. All the way across the
  /// disc its dives then turn below the keel, and it must not come to the surface.
  bool pass_under{false};
  /// Kept between the deepest keel and the upper turn. Default: twice as much as the vehicles keep above the sea bed,
  /// because turns overshoot by metres and a keel is not flat.
  core::Metres keel_clearance{20.0};
  /// Share that is added to every draft. Default: a caution of our own, no scatter is published with the relations; for
  /// a given length those in use differ by up to 1.6 times, and of those the deepest is taken already.
  double draft_uncertainty{0.25};

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

}  // namespace floeplan::planning
