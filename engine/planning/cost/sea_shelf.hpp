#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <stop_token>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::cost {

/// Cache of the gridded currents of one environment. It keeps the two grids that were used last, because a
/// request may use a smaller and a larger one. Requests with the same key share a grid.
/// Threads  one at a time
class CurrentsShelf {
 public:
  /// `environment` is borrowed and must outlive the cache.
  explicit CurrentsShelf(const ocean::Environment& environment) : environment_{environment} {}

  /// The currents that `lay_out_currents` makes for these arguments in the environment of the cache; from the
  /// cache if they are there. Once `stop` is requested they are incomplete, and not cached.
  [[nodiscard]] std::shared_ptr<const currents::PlaneCurrents> take(
      const PlanRequest& request, const currents::FlownDepths& depths, const ice::UnderIce* ice,
      const geo::LocalProjection& projection, const plane::PlaneBox& area, const std::stop_token& stop);
  /// Whether the currents of the request are in the cache.
  [[nodiscard]] bool holds(const PlanRequest& request, const geo::LocalProjection& projection,
                           const plane::PlaneBox& area) const;

 private:
  /// The values that limit the upper turn of dives below ice.
  struct BelowIce {
    double max_concentration_to_surface;
    core::Metres margin;
    core::Metres draft_if_unknown;

    friend bool operator==(const BelowIce&, const BelowIce&) = default;
  };
  /// Everything in a request that its gridded currents depend on.
  struct Key {
    geo::LonLat origin;  // of the plane
    plane::PlaneBox area;
    core::UtcTime epoch;
    vehicle::DiveLimits limits;
    std::optional<BelowIce> below_ice;  // empty: no ice data

    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Kept {
    Key key;
    std::shared_ptr<const currents::PlaneCurrents> currents;
  };
  static constexpr std::size_t most_kept = 2;

  [[nodiscard]] Key key_of(const PlanRequest& request, const geo::LocalProjection& projection,
                           const plane::PlaneBox& area) const;

  const ocean::Environment& environment_;
  std::deque<Kept> kept_;  // most recently used first
};

}  // namespace floeplan::planning::cost
