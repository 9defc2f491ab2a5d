#pragma once

#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "engine/ocean/environment.hpp"
#include "storage/repository/environment/environment_query.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

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
    sql::Connection& db, const EnvironmentQuery& query, const Reading& reading = {});

}  // namespace floeplan::repository
