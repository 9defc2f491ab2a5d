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

  [[nodiscard]] core::Violations violations() const;  // empty when valid, otherwise all of them
};

}  // namespace floeplan::planning
