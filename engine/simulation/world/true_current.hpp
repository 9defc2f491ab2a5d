#pragma once

#include <memory>
#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/simulation/world/current_error_field.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// The true velocity of the water: a uniform flow, the forecast if there is one, and the forecast's error.
/// Frame    east and north of the flight's frame, m/s; no vertical component
/// Depth    above the first level of the forecast the current of the first level, below the last level the
///          current of the last. Where the model's water is shallower, the current of its deepest water
/// Coast    for a node without water, the current of the nearest water up to two cells away: models have
///          coarse coasts
/// Outside  empty outside the forecast's area (and those cells) and period; a steady forecast is valid at
///          every time
/// Threads  const members may be called from several threads at once
class TrueCurrent {
 public:
  struct Forecast {
    std::shared_ptr<const ocean::CurrentGrid> grid;
    bool steady{};  // a single time, valid at every time
  };

  TrueCurrent() = default;  // still water
  TrueCurrent(Vector uniform, CurrentErrorField error) : uniform_{uniform}, error_{std::move(error)} {}
  TrueCurrent(Forecast forecast, const geo::LocalProjection& projection, CurrentErrorField error)
      : forecast_{std::move(forecast)}, projection_{projection}, error_{std::move(error)} {}

  [[nodiscard]] std::optional<Vector> at(Vector place, core::UtcTime time) const;
  /// The error that is added to the forecast.
  [[nodiscard]] Vector error_at(Vector place, core::UtcTime time) const { return error_.at(place, time); }
  /// The current as known on shore: without the error.
  [[nodiscard]] std::optional<Vector> forecast_at(Vector place, core::UtcTime time) const;

 private:
  Vector uniform_{};
  Forecast forecast_{};
  std::optional<geo::LocalProjection> projection_;
  CurrentErrorField error_{};
};

}  // namespace floeplan::simulation
