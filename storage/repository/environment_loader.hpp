#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/ocean/sighting_age.hpp"
#include "storage/repository/current_grid_cache.hpp"
#include "storage/repository/dataset_choice.hpp"
#include "storage/repository/tide_environment.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// The last moment that the data have to cover, and the input that asks for it.
struct CoveredUntil {
  std::string input;
  core::UtcTime time;
};

/// What a job wants to know of the sea.
struct EnvironmentQuery {
  geo::BoundingBox area;
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

/// After this no sighting counts: `icebergs_as_of`, else the departure, or the last moment where data may begin later.
[[nodiscard]] core::UtcTime sightings_as_of(const EnvironmentQuery& query);

/// What reading the store for a job may look at beside the store.
struct Reading {
  std::stop_token stop{};
  CurrentGridCache* kept_currents{nullptr};  // borrowed; null: everything is read anew
};

/// Puts together the snapshot for one job from the newest (or the named) datasets that meet the area and
/// the period, all as they stood at one moment.
/// Errors   a violation for each named dataset that does not exist, is of another kind or shares nothing
///          with the area, and for a departure (or a moment to cover) outside the period of the currents
///          unless they are held steady
/// Edges    currents are read from the last step before departure (before the oldest iceberg sighting in use,
///          when icebergs drift) to their end: how long a plan takes is not yet known. Currents without time are
///          held steady. Drifting icebergs are also read up to 100 km beyond the area, and with them the
///          currents that carry them, down to their keels (less far where these are more than 32 million
///          samples); messages name those of which the current is not known. Icebergs there that are left out for
///          the age of their sightings are a danger. Ice is taken that
///          counts at some time of a mission of 30 days from the latest departure on, or that ended no more than 30
///          days before the earliest; a named one whose period, lengthened by ocean::longest_ice_hold, does not cover
///          the earliest departure is refused
/// Stops    early once `reading.stop` is requested; what is returned then is incomplete and must not be used
[[nodiscard]] tl::expected<ocean::Environment, core::Violations> load_environment(
    sqlite::Connection& db, const EnvironmentQuery& query, const Reading& reading = {});

}  // namespace floeplan::repository
