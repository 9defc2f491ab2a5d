#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// How deep an iceberg reaches, as far as is known, and how deep the dives turn below it.
struct Keel {
  core::Metres draft;       // stated, or the largest that the length lets expect
  bool draft_is_stated{};   // in the sighting
  core::Metres deepest;     // with the uncertainty that the rules add
  core::Metres upper_turn;  // of the dives: the clearance below that
};

}  // namespace floeplan::planning
