#pragma once

#include <cstdint>

namespace floeplan::vehicle {

/// The kinds of propulsion for a leg.
enum class Drive : std::uint8_t { buoyancy, thruster };

}  // namespace floeplan::vehicle
