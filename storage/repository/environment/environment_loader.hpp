#pragma once

#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "engine/ocean/environment.hpp"
#include "storage/repository/environment/environment_query.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Assembles the snapshot for one job from the newest (or the named) datasets that intersect the area and the
/// period. All are read in the same state of the store.
/// Errors   a violation for each named dataset that does not exist, is of another kind or does not intersect
///          the area; for a departure (or a time to cover) outside the period of the currents, unless they
///          are held steady; for a named ice dataset whose period, extended by ocean::longest_ice_hold, does
///          not cover the earliest departure
/// Edges    Currents are read from the last step before the departure to their end, because the duration of a
///          plan is not known yet; if icebergs drift, from the last step before the oldest sighting in use.
///          Currents without time are held steady. Icebergs are read up to 100 km beyond the area, because
///          they may drift into it, with the currents there down to their keels (less far if these are more
///          than 32 million samples). Messages name icebergs whose current is not known, and icebergs ignored
///          for the age of their sightings, which are a danger. Ice is read for a mission of 30 days from the
///          latest departure on, and from up to 30 days before the earliest.
/// Stops    early once `reading.stop` is requested; the result is then incomplete and must not be used
[[nodiscard]] tl::expected<ocean::Environment, core::Violations> load_environment(
    sql::Connection& db, const EnvironmentQuery& query, const Reading& reading = {});

}  // namespace floeplan::repository
