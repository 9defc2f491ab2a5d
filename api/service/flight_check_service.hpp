#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/document.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::service {

/// Judges mission files that are to fly together in the stored data, and adds to their messages.
/// `inputs`  what a plan takes besides its places: departure, vehicle, margins, choice of data
/// `start`   where the vehicle is; without it the first waypoint is the start
/// Errors    every violation of the inputs and of the choice of data
[[nodiscard]] core::Violations check_flight(sql::Connection& db, const nlohmann::json& inputs,
                                            std::optional<geo::LonLat> start,
                                            std::vector<mission::Document>& documents);

/// Compares the goto lists among the files with a stored plan, and adds to their messages.
/// Errors    no plan has the id
[[nodiscard]] core::Violations compare_with_plan(sql::Connection& db, const std::string& plan_id,
                                                 std::vector<mission::Document>& documents);

}  // namespace floeplan::service
