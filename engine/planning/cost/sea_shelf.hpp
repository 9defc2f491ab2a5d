#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/currents/plane_currents.hpp"
#include "engine/planning/ice/under_ice.hpp"
#include "engine/planning/obstacles/bed_cells.hpp"
#include "engine/planning/obstacles/iceberg_discs.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/vehicle/dive_band.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::planning::cost {

/// Cache of gridded parts of planning domains. Requests and environments that agree in all that a part depends on
/// share it. It keeps the two parts of each kind that were used last, because a request may use a smaller and a
/// larger area.
/// Parts    what the function of the same name in sea_layout.hpp makes for these arguments. Once `stop` is requested
///          they are incomplete, and not cached
/// Threads  members may be called from several threads at once. Threads that ask for the same part at the same time
///          may each make it
class SeaShelf {
 public:
  [[nodiscard]] std::shared_ptr<const obstacles::BedCells> bed_below(const ocean::Environment& environment,
                                                                     const PlanRequest& request,
                                                                     const geo::LocalProjection& projection,
                                                                     const plane::PlaneBox& area,
                                                                     core::Metres cell,
                                                                     const std::stop_token& stop);
  /// Icebergs that may be passed under depend on much more, so they are never shared.
  [[nodiscard]] std::shared_ptr<const obstacles::IcebergDiscs> icebergs(
      const ocean::Environment& environment, const PlanRequest& request,
      const geo::LocalProjection& projection, const plane::PlaneBox& area,
      std::shared_ptr<const obstacles::BedCells> bed, const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<const currents::PlaneCurrents> currents(
      const ocean::Environment& environment, const PlanRequest& request, const currents::FlownDepths& depths,
      const ice::UnderIce* ice, const geo::LocalProjection& projection, const plane::PlaneBox& area,
      const std::stop_token& stop);
  /// Whether the currents of the request are in the cache.
  [[nodiscard]] bool holds_currents(const ocean::Environment& environment, const PlanRequest& request,
                                    const geo::LocalProjection& projection,
                                    const plane::PlaneBox& area) const;

 private:
  /// Parts of one kind, most recently used first.
  template <class Key, class Part>
  class Kept {
   public:
    template <class Make>
    std::shared_ptr<const Part> take(const Key& key, const std::stop_token& stop, const Make& make) {
      if (auto known = find(key)) return *known;
      const std::shared_ptr<const Part> made = make();
      if (stop.stop_requested()) return made;  // incomplete: must not be kept
      const std::scoped_lock lock{mutex_};
      if (parts_.size() == most_kept) parts_.pop_back();
      parts_.push_front({key, made});
      return made;
    }
    [[nodiscard]] bool holds(const Key& key) const {
      const std::scoped_lock lock{mutex_};
      return std::ranges::find(parts_, key, &Entry::key) != parts_.end();
    }

   private:
    static constexpr std::size_t most_kept = 2;
    struct Entry {
      Key key;
      std::shared_ptr<const Part> part;
    };
    std::optional<std::shared_ptr<const Part>> find(const Key& key) {
      const std::scoped_lock lock{mutex_};
      const auto found = std::ranges::find(parts_, key, &Entry::key);
      if (found == parts_.end()) return std::nullopt;
      std::rotate(parts_.begin(), found, found + 1);
      return parts_.front().part;
    }

    mutable std::mutex mutex_;
    std::deque<Entry> parts_;
  };

  /// A part of the plane and where it lies on the Earth.
  struct Site {
    geo::LonLat origin;  // of the plane
    plane::PlaneBox area;

    friend bool operator==(const Site&, const Site&) = default;
  };
  /// Data are known by their addresses. The keys own them, so no address is used again.
  struct BedKey {
    std::shared_ptr<const ocean::Bathymetry> bathymetry;
    bool is_passed_below;
    vehicle::GliderProfile vehicle;
    Site site;
    core::Metres cell;

    friend bool operator==(const BedKey&, const BedKey&) = default;
  };
  struct IcebergsKey {
    std::vector<ocean::Iceberg> icebergs;
    std::shared_ptr<const ocean::CurrentGrid> carrying;
    bool steady;
    std::shared_ptr<const ocean::CurrentGrid> wind;
    std::shared_ptr<const ocean::Bathymetry> bathymetry;
    IcebergRules rules;
    Site site;
    core::UtcTime epoch;
    core::Seconds horizon;
    bool is_direct;

    friend bool operator==(const IcebergsKey&, const IcebergsKey&) = default;
  };
  /// The values that limit the upper turn of dives below ice.
  struct BelowIce {
    std::shared_ptr<const ocean::IceField> ice;
    std::vector<std::shared_ptr<const ocean::IceField>> further_ice;
    double max_concentration_to_surface;
    core::Metres margin;
    core::Metres draft_if_unknown;

    friend bool operator==(const BelowIce&, const BelowIce&) = default;
  };
  struct CurrentsKey {
    std::shared_ptr<const ocean::CurrentGrid> currents;
    bool steady;
    std::shared_ptr<const ocean::Bathymetry> bathymetry;
    Site site;
    core::UtcTime epoch;
    vehicle::DiveLimits limits;
    std::optional<BelowIce> below_ice;  // empty: no ice data

    friend bool operator==(const CurrentsKey&, const CurrentsKey&) = default;
  };
  static CurrentsKey currents_key(const ocean::Environment& environment, const PlanRequest& request,
                                  const geo::LocalProjection& projection, const plane::PlaneBox& area);

  Kept<BedKey, obstacles::BedCells> beds_;
  Kept<IcebergsKey, obstacles::IcebergDiscs> icebergs_;
  Kept<CurrentsKey, currents::PlaneCurrents> currents_;
};

}  // namespace floeplan::planning::cost
