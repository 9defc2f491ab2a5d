#pragma once

namespace floeplan::vehicle {

/// Density of sea water at 35 g/kg, 5 degrees and the surface by the UNESCO equation of state (EOS-80),
/// 1027.7 kg/m3. The real density differs by less than one per cent; this is far below the uncertainty of a
/// vehicle's drag.
inline constexpr double sea_water_density_kg_m3 = 1027.7;
inline constexpr double gravity_m_s2 = 9.81;

}  // namespace floeplan::vehicle
