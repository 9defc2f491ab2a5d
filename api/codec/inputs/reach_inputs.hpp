#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/planning/problem/isochrone_request.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// Inputs of process reach. Area, period and dive depth of `data` are derived from the request.
struct ReachInputs {
  planning::IsochroneRequest request;
  repository::EnvironmentQuery data;
  std::string name;
  std::vector<std::string> warnings;  // inputs that are ignored
};

/// Reads "from" and "depart", or "to" and "arrive_by"; "hours" as one number or several; grid, vehicle,
/// margin and data as in process plan-route.
/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs`
[[nodiscard]] tl::expected<ReachInputs, core::Violations> parse_reach_inputs(const nlohmann::json& inputs);

/// The inputs with all defaults filled in and keys in a fixed order.
[[nodiscard]] nlohmann::json to_json(const ReachInputs& inputs);

}  // namespace floeplan::codec
