#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ocean {

/// Velocity that the wind gives an iceberg relative to the water that carries it. A small one moves downwind
/// at about 2 % of the wind speed. A large one is slower and deflected, to the right in the northern
/// hemisphere, to the left in the southern.
/// Frame    local east-north; `wind` is 10 m above the sea and points where the air goes
/// Units    m/s; `length` at the waterline, positive
/// Edges    zero without wind; straight downwind at the equator
/// Source   Wagner, Dell and Eisenman 2017, An analytical model of iceberg drift, J. Phys. Oceanogr. 47, the
///          balance of drag and Coriolis force. Difference: its alpha and beta are computed from the speed of
///          their sum, which loses no digits for large icebergs. Ratio of length to width 1.62 after
///          Dowdeswell
[[nodiscard]] geo::VelocityEn moved_by_wind(geo::VelocityEn wind, core::Metres length, double latitude_deg);

}  // namespace floeplan::ocean
