#pragma once

#include <memory>
#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/simulation/world/current_error_field.hpp"
#include "engine/simulation/world/space.hpp"

namespace floeplan::simulation {

/// The water's real velocity: a uniform flow, the forecast where there is one, and the forecast's error.
/// Frame    east and north of the flight's frame, m/s; never up or down
/// Depth    above the forecast's first level the current of that level counts, below its last level that of the last; where
///          the model's water is not so deep, that of its deepest water
/// Coast    where a node has no water, the current of the nearest water counts, up to two cells away: the coasts of models are
///          coarse
/// Outside  empty beyond the forecast's area (and those cells) and period; a forecast held steady answers for every
///          time
/// Threads  const members may be called from several threads at once
class TrueCurrent {
 public:
  struct Forecast {
    std::shared_ptr<const ocean::CurrentGrid> grid;
    bool steady{};  // it holds one time, meant for every time
  };

  TrueCurrent() = default;  // still water
  TrueCurrent(Vector uniform, CurrentErrorField error) : uniform_{uniform}, error_{std::move(error)} {}
  TrueCurrent(Forecast forecast, const geo::LocalProjection& projection, CurrentErrorField error)
      : forecast_{std::move(forecast)}, projection_{projection}, error_{std::move(error)} {}

  [[nodiscard]] std::optional<Vector> at(Vector place, core::UtcTime time) const;
  /// What is added to the forecast.
  [[nodiscard]] Vector error_at(Vector place, core::UtcTime time) const { return error_.at(place, time); }
  /// What the shore knows of it: all but the error.
  [[nodiscard]] std::optional<Vector> forecast_at(Vector place, core::UtcTime time) const;

 private:
  Vector uniform_{};
  Forecast forecast_{};
  std::optional<geo::LocalProjection> projection_;
  CurrentErrorField error_{};
};

}  // namespace floeplan::simulation
