#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/ocean/currents/vehicle_axes.hpp"

namespace floeplan::codec {

/// From which axes of a vehicle currents were turned to true east and north: the zone of its grid, the declination
/// (degrees, east positive: minus the vehicle's magnetic variation) and whose word that is.
[[nodiscard]] nlohmann::json vehicle_axes_document(const ocean::VehicleAxes& known);

}  // namespace floeplan::codec
