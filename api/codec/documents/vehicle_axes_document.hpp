#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/ocean/currents/vehicle_axes.hpp"

namespace floeplan::codec {

/// The axes of a vehicle from which currents were rotated to true east and north: the zone of its grid, the
/// declination (degrees, east positive: minus the vehicle's magnetic variation), and who stated it.
[[nodiscard]] nlohmann::json vehicle_axes_document(const ocean::VehicleAxes& known);

}  // namespace floeplan::codec
