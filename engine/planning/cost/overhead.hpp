#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"

namespace floeplan::planning::cost {

/// What is above the vehicle, ice and icebergs that it may pass under: whether it may come to the surface, how deep its
/// dives must turn, and for how long it may stay below.
/// Threads  const members may be called from several threads at once
class Overhead {
 public:
  /// `ice`: empty where nothing is known of ice in the whole area. `longest_without_surfacing`: empty: for as long as it
  /// takes.
  Overhead(std::optional<ice::UnderIce> ice, obstacles::IcebergDiscs icebergs,
           std::optional<core::Seconds> longest_without_surfacing)
      : ice_{std::move(ice)},
        icebergs_{std::move(icebergs)},
        longest_without_surfacing_{longest_without_surfacing} {}

  [[nodiscard]] const std::optional<ice::UnderIce>& ice() const { return ice_; }
  [[nodiscard]] const obstacles::IcebergDiscs& icebergs() const { return icebergs_; }

  /// Whether the vehicle may come to the surface: anywhere where nothing is known of ice in the whole area.
  [[nodiscard]] bool may_surface(geo::PlanePoint point, core::Seconds time) const {
    return (!ice_ || ice_->may_surface(point, time)) && !icebergs_.least_upper_turn(point, time);
  }
  /// The same, and whether there is room below the ice from the last look at it; `watch` is empty where nothing is
  /// known of ice.
  [[nodiscard]] ice::UnderIce::Leave leave(std::optional<ice::IceWatch>& watch, geo::PlanePoint point,
                                           core::Seconds time) const;
  /// How close together looks at it are.
  [[nodiscard]] core::Metres look() const;
  /// The least depth at which dives may turn at this place and time, below ice or an iceberg's keel; zero where
  /// nothing is above.
  [[nodiscard]] core::Metres least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
    const core::Metres of_ice = ice_ ? ice_->least_upper_turn(point, time) : core::Metres{0.0};
    return std::max(of_ice, icebergs_.least_upper_turn(point, time).value_or(core::Metres{0.0}));
  }
  /// Whether dives may have to turn deeper somewhere on the straight way.
  [[nodiscard]] bool may_be_above(geo::PlanePoint a, geo::PlanePoint b) const {
    return (ice_ && ice_->may_be_dense_along(a, b)) || icebergs_.may_pass_under();
  }
  /// Whether the time without a possible surfacing is bounded, and something may be above the vehicle, so that a leg
  /// depends on those before it.
  [[nodiscard]] bool bounds_surfacing() const {
    return longest_without_surfacing_ && (ice_ || icebergs_.may_pass_under());
  }
  [[nodiscard]] std::optional<core::Seconds> longest_without_surfacing() const {
    return longest_without_surfacing_;
  }
  void lift_bound_on_surfacing() { longest_without_surfacing_.reset(); }

 private:
  std::optional<ice::UnderIce> ice_;
  obstacles::IcebergDiscs icebergs_;
  std::optional<core::Seconds> longest_without_surfacing_;
};

}  // namespace floeplan::planning::cost
