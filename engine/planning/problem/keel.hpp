#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// The draft of an iceberg, and the depth at which dives turn below it.
struct Keel {
  core::Metres draft;       // stated by the sighting, otherwise the largest draft that its length suggests
  bool draft_is_stated{};   // whether the sighting states the draft
  core::Metres deepest;     // the draft plus the share `IcebergRules::draft_uncertainty`
  core::Metres upper_turn;  // upper turn of the dives: the clearance below `deepest`
};

}  // namespace floeplan::planning
