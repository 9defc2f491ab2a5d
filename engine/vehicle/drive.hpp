#pragma once

#include <cstdint>

namespace floeplan::vehicle {

/// What drives the vehicle along a leg.
enum class Drive : std::uint8_t { buoyancy, thruster };

}  // namespace floeplan::vehicle
