#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ocean {

/// How the wind moves an iceberg against the water that carries it: a small one before the wind at about 2 % of its
/// speed, a large one slower and more aside, to the right of the wind in the north and to the left in the south.
/// Frame    local east-north; the wind 10 m above the sea, towards which it blows
/// Units    m/s; `length` at the waterline, more than zero
/// Edges    zero without wind; at the equator straight before it
/// Source   Wagner, Dell and Eisenman 2017, An analytical model of iceberg drift, J. Phys. Oceanogr. 47, the balance
///          of drag and Coriolis force; difference: its alpha and beta by the speed of their sum, which loses no
///          digits for large icebergs. Length to width as Dowdeswell found: 1.62
[[nodiscard]] geo::VelocityEn moved_by_wind(geo::VelocityEn wind, core::Metres length, double latitude_deg);

}  // namespace floeplan::ocean
