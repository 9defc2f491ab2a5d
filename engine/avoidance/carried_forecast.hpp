#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"

namespace floeplan::avoidance {

/// The current that the plan was made with, on a small grid that the vehicle carries along: linear between its
/// points in place, depth and time. Immutable.
/// Frame    the flight's local plane; velocities over the ground
/// Edges    outside the grid, and before and after its times, the nearest value: a vehicle at sea cannot refuse
/// Threads  const members may be called from several threads at once
class CarriedForecast {
 public:
  /// A regular grid of places, and rising depths and times.
  struct Grid {
    geo::PlanePoint origin{};  // of the first column and row
    core::Metres spacing{1000.0};
    int columns{1};
    int rows{1};
    std::vector<core::Metres> depths{};
    std::vector<core::UtcTime> times{};
    std::vector<geo::VelocityEn> values{};  // [time][depth][row][column]
  };

  /// The same water everywhere and always.
  explicit CarriedForecast(geo::VelocityEn everywhere);
  /// Errors  std::invalid_argument for axes that are empty or do not rise, for a wrong number of values and for a
  ///         value that is not finite
  explicit CarriedForecast(Grid grid);

  [[nodiscard]] geo::VelocityEn at(geo::PlanePoint place, core::Metres depth, core::UtcTime time) const;

 private:
  Grid grid_;
};

}  // namespace floeplan::avoidance
