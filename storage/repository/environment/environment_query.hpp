#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "engine/core/units.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/ice/sighting_age.hpp"
#include "storage/repository/datasets/dataset_choice.hpp"
#include "storage/repository/environment/tide_environment.hpp"
#include "storage/repository/fields/current_grid_cache.hpp"

namespace floeplan::repository {

/// The latest time that the data have to cover, and the name of the input that demands it.
struct CoveredUntil {
  std::string input;
  core::UtcTime time;
};

/// The data of the sea that a job needs.
struct EnvironmentQuery {
  geo::BoundingBox area;
  /// Area around the start, the via points and the goal. Messages about data missing in all of it name it
  /// instead of the whole area. Empty: they name the area.
  std::optional<geo::BoundingBox> around_stops{};
  core::UtcTime depart;
  std::optional<CoveredUntil> until;  // to be covered as well; empty: the duration is not known
  bool may_begin_later{false};        // `depart` is the earliest departure; data may begin later
  core::Metres dive_depth{200.0};
  DatasetChoice currents;
  DatasetChoice wind;  // read only if icebergs drift, unless one is named
  bool steady{false};  // currents held steady: one time step, or the mean of all steps, for all times
  TidesQuery tides;
  DatasetChoice bathymetry;
  DatasetChoice ice;
  DatasetChoice icebergs;
  std::optional<core::UtcTime> icebergs_as_of;  // default: the departure, or `until` if data may begin later
  /// Oldest sighting that counts, by the rule of ocean::oldest_that_counts. If data may begin later, a
  /// sighting counts if it is young enough for the earliest departure; it also has the departure for which it
  /// becomes too old.
  core::Seconds max_sighting_age{ocean::max_sighting_age};
  // also reads tracks of icebergs, and currents since the sightings, for their drift
  bool iceberg_drift{true};
  DatasetChoice coastline;
  DatasetChoice zones;  // default: all zones that intersect the area are obeyed
};

/// The area to name in messages about missing data.
[[nodiscard]] geo::BoundingBox named_area(const EnvironmentQuery& query);

/// The latest time of a sighting that counts: `icebergs_as_of`, or else the departure, or `until` if data may
/// begin later.
[[nodiscard]] core::UtcTime sightings_as_of(const EnvironmentQuery& query);

/// The objects that a job needs, besides the store, to read the store.
struct Reading {
  std::stop_token stop{};
  CurrentGridCache* kept_currents{nullptr};  // borrowed; null: nothing is cached
};

}  // namespace floeplan::repository
