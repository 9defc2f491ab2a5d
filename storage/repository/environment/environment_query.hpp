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

/// The last moment that the data have to cover, and the input that asks for it.
struct CoveredUntil {
  std::string input;
  core::UtcTime time;
};

/// What a job wants to know of the sea.
struct EnvironmentQuery {
  geo::BoundingBox area;
  /// Around the start, the via points and the goal: the part of the area that messages name where data are missing in
  /// all of it. Empty: they name the area.
  std::optional<geo::BoundingBox> around_stops{};
  core::UtcTime depart;
  std::optional<CoveredUntil> until;  // covered too; empty: however long it takes
  bool may_begin_later{false};        // `depart` is the earliest possible one: data may begin after it
  core::Metres dive_depth{200.0};
  DatasetChoice currents;
  DatasetChoice wind;  // only where icebergs drift, unless one is named
  bool steady{false};  // one time step, or the mean of all, for every time
  TidesQuery tides;
  DatasetChoice bathymetry;
  DatasetChoice ice;
  DatasetChoice icebergs;
  std::optional<core::UtcTime>
      icebergs_as_of;  // default: the departure, or `until` where data may begin later
  /// By the rule of ocean::oldest_that_counts. Where data may begin later, icebergs count that are young enough for the
  /// earliest departure, each with the departure for which it is too old.
  core::Seconds max_sighting_age{ocean::max_sighting_age};
  bool iceberg_drift{true};  // also what their drift needs: tracks, and currents from the sightings on
  DatasetChoice coastline;
  DatasetChoice zones;  // obeyed are all that meet the area, unless some are named
};

/// The part of the area that messages about missing data name.
[[nodiscard]] geo::BoundingBox named_area(const EnvironmentQuery& query);

/// After this no sighting counts: `icebergs_as_of`, else the departure, or the last moment where data may begin later.
[[nodiscard]] core::UtcTime sightings_as_of(const EnvironmentQuery& query);

/// What reading the store for a job may look at beside the store.
struct Reading {
  std::stop_token stop{};
  CurrentGridCache* kept_currents{nullptr};  // borrowed; null: everything is read anew
};

}  // namespace floeplan::repository
