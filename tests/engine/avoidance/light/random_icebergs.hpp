#pragma once

#include <cstdint>

#include "tests/engine/avoidance/light/voyage.hpp"

namespace floeplan::support {

/// The parameters of a random field of icebergs.
struct IcebergField {
  double route_m{5000.0};
  double km2_for_each{1.5};
  double median_length_m{63.0};  // geometric mean of the least and the greatest
  double length_sigma{0.6};      // of its logarithm
  double least_length_m{20.0};
  double most_length_m{200.0};
  double most_drift{0.5};  // of the vehicle's speed, through the water
  double most_turn_deg_h{20.0};
  double current_m_s{0.1};        // of the forecast, in any direction
  double current_error_m_s{0.1};  // rms of a component
  double free_round_start_m{150.0};
};

/// A flight eastwards along the route, through bergs at random places that the plan does not contain. The
/// bergs are half ellipsoids. Their draft is 2.91 L^0.71 for the length L (Barker, Sayed and Carrieres 2004),
/// and their width is 0.55 to 0.95 of the length.
[[nodiscard]] Flight random_icebergs(std::uint64_t seed, const IcebergField& field = {});

/// Whether a vehicle with full knowledge could have avoided the collision after its sonar first met the body:
/// whether some constant heading, or one change of heading, would have kept it clear of every body for twenty
/// minutes.
[[nodiscard]] bool could_be_saved(const Flight& flight, const FlightResult& result);

}  // namespace floeplan::support
