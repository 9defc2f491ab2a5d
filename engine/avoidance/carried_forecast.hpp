#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::avoidance {

/// The current forecast of the plan on a small grid that is stored on the vehicle: linear in place, depth and
/// time. Immutable.
/// Frame    the flight's local plane; velocities over the ground
/// Edges    outside the grid and its times the nearest value, because a vehicle at sea needs an answer
/// Threads  const members may be called from several threads at once
class CarriedForecast {
 public:
  /// A regular grid of places, with ascending depths and times.
  struct Grid {
    geo::PlanePoint origin{};  // of the first column and row
    core::Metres spacing{1000.0};
    int columns{1};
    int rows{1};
    std::vector<core::Metres> depths{};
    std::vector<core::UtcTime> times{};
    std::vector<geo::VelocityEn> values{};  // [time][depth][row][column]
  };

  /// A current that is the same everywhere and at all times.
  explicit CarriedForecast(geo::VelocityEn everywhere);
  /// Errors  std::invalid_argument for axes that are empty or not ascending, a wrong number of values, and
  ///         values that are not finite
  explicit CarriedForecast(Grid grid);

  [[nodiscard]] geo::VelocityEn at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const;

 private:
  Grid grid_;
};

}  // namespace floeplan::avoidance
