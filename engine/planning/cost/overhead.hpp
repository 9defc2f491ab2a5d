#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"

namespace floeplan::planning::cost {

/// Ice and icebergs above the vehicle: whether it may surface, how deep its dives must turn, and how long it
/// may stay under water.
/// Threads  const members may be called from several threads at once
class Overhead {
 public:
  /// `ice`: empty if the whole area has no ice data. `longest_without_surfacing`: empty means no limit.
  Overhead(std::optional<ice::UnderIce> ice, std::shared_ptr<const obstacles::IcebergDiscs> icebergs,
           std::optional<core::Seconds> longest_without_surfacing)
      : ice_{std::move(ice)},
        icebergs_{std::move(icebergs)},
        longest_without_surfacing_{longest_without_surfacing} {}

  [[nodiscard]] const std::optional<ice::UnderIce>& ice() const { return ice_; }
  [[nodiscard]] const obstacles::IcebergDiscs& icebergs() const { return *icebergs_; }

  /// Whether the vehicle may surface. True everywhere if the whole area has no ice data.
  [[nodiscard]] bool may_surface(geo::PlanePoint point, core::Seconds time) const {
    return (!ice_ || ice_->may_surface(point, time)) && !icebergs_->least_upper_turn(point, time);
  }
  /// Whether the vehicle may surface, and whether there was room below the ice since the last check of
  /// `watch`. An empty
  /// `watch` means that there are no ice data.
  [[nodiscard]] ice::UnderIce::Leave leave(std::optional<ice::IceWatch>& watch, geo::PlanePoint point,
                                           core::Seconds time) const;
  /// Distance between checks of the ice above.
  [[nodiscard]] core::Metres look() const;
  /// Shallowest depth at which dives may turn at this place and time, below ice or the keel of an iceberg. Zero where
  /// nothing is above.
  [[nodiscard]] core::Metres least_upper_turn(geo::PlanePoint point, core::Seconds time) const {
    const core::Metres of_ice = ice_ ? ice_->least_upper_turn(point, time) : core::Metres{0.0};
    return std::max(of_ice, icebergs_->least_upper_turn(point, time).value_or(core::Metres{0.0}));
  }
  /// Whether ice or an iceberg may force dives to turn deeper somewhere on the straight line.
  [[nodiscard]] bool may_be_above(geo::PlanePoint a, geo::PlanePoint b) const {
    return (ice_ && ice_->may_be_dense_along(a, b)) || icebergs_->may_pass_under();
  }
  /// Whether the time without surfacing is limited and something may be above the vehicle. If so, whether a
  /// leg is open depends on the legs before it.
  [[nodiscard]] bool bounds_surfacing() const {
    return longest_without_surfacing_ && (ice_ || icebergs_->may_pass_under());
  }
  [[nodiscard]] std::optional<core::Seconds> longest_without_surfacing() const {
    return longest_without_surfacing_;
  }
  void lift_bound_on_surfacing() { longest_without_surfacing_.reset(); }

 private:
  std::optional<ice::UnderIce> ice_;
  std::shared_ptr<const obstacles::IcebergDiscs>
      icebergs_;  // never null; domains with the same icebergs share it
  std::optional<core::Seconds> longest_without_surfacing_;
};

}  // namespace floeplan::planning::cost
