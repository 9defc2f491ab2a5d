#pragma once

namespace floeplan::motion {

/// Why an edge cannot be travelled, cheap enough for the inner loop.
enum class EdgeClosed {
  current_too_strong,
  outside_data,
  too_shallow,
  on_land,
  obstacle,
  in_zone,       // against the rule of a zone
  under_ice,     // no room between the ice and the sea bed, or below the reach of the dives
  no_surfacing,  // the last place where the vehicle may surface lies too far back
  too_late       // it would end later than the caller cares for
};

}  // namespace floeplan::motion
