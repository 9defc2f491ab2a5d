#pragma once

namespace floeplan::motion {

/// Why an edge cannot be travelled; cheap to return in the inner loop.
enum class EdgeClosed {
  current_too_strong,
  outside_data,
  too_shallow,
  on_land,
  obstacle,
  in_zone,       // against a zone's rule
  under_ice,     // no room between ice and sea bed, or deeper than the dives reach
  no_surfacing,  // time without surfacing beyond its limit
  too_late       // would end after the latest time of the caller
};

}  // namespace floeplan::motion
