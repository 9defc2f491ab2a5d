#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::ocean {

/// Horizontal velocity of the sea water as a function of place, depth and time.
/// Frame    local east-north at the query point; points where the water goes
/// Units    m/s; depth in metres, positive down; UTC
/// Outside  nullopt over land, beyond the covered box and beyond the covered period; never extrapolates
/// Errors   std::invalid_argument for a non-finite argument
/// Threads  const members may be called from several threads at once
class CurrentField {
 public:
  virtual ~CurrentField() = default;
  [[nodiscard]] virtual std::optional<geo::VelocityEn> at(geo::LonLat place, core::Metres depth,
                                                          core::UtcTime time) const = 0;
};

}  // namespace floeplan::ocean
