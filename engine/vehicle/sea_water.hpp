#pragma once

namespace floeplan::vehicle {

/// Density of water at 35 g/kg and 5 degrees at the surface by UNESCO's equation of state (EOS-80, 1027.7); what the
/// sea's own density differs from it is below one per cent, far below what is known of a vehicle's drag.
inline constexpr double sea_water_density_kg_m3 = 1027.7;
inline constexpr double gravity_m_s2 = 9.81;

}  // namespace floeplan::vehicle
