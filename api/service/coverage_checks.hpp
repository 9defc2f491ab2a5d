#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/core/violation_list.hpp"
#include "engine/geo/lon_lat.hpp"
#include "storage/repository/environment/environment_query.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// A place of a request, and the field that gives it: "from", "via/0".
using GivenPlace = std::pair<std::string, geo::LonLat>;

/// The places whose longitude and latitude are probably exchanged: they lie outside all stored currents and
/// bathymetry, but would lie inside some if exchanged. Empty for a request that uses neither.
[[nodiscard]] core::Violations swapped_places(sql::Connection& db, const std::vector<GivenPlace>& places,
                                              const repository::EnvironmentQuery& data);

/// Refuses a request if bathymetry is stored, but none of it reaches the area of the request, and the request
/// leaves the choice of bathymetry to the program. Every start would then lie outside the depths, wherever
/// the goal lies. Empty if no bathymetry is stored, or if the request names some or wants none.
[[nodiscard]] core::Violations depths_elsewhere(sql::Connection& db,
                                                const repository::EnvironmentQuery& data);

}  // namespace floeplan::service
