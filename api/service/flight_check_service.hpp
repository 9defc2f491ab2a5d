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

/// Checks mission files of one flight in the stored data, and adds messages to them.
/// `inputs`  inputs of a plan except its waypoints: departure, vehicle, margins, choice of data
/// `start`   position of the vehicle; default: the first waypoint
/// Errors    all violations of the inputs and of the choice of data
[[nodiscard]] core::Violations check_flight(sql::Connection& db, const nlohmann::json& inputs,
                                            std::optional<geo::LonLat> start,
                                            std::vector<mission::Document>& documents);

/// Compares the goto lists among the files with a stored plan, and adds messages to them.
/// Errors    there is no plan with this id
[[nodiscard]] core::Violations compare_with_plan(sql::Connection& db, const std::string& plan_id,
                                                 std::vector<mission::Document>& documents);

}  // namespace floeplan::service
