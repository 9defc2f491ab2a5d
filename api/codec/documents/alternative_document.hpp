#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/planning/problem/alternative.hpp"

namespace floeplan::codec {

/// The entry of an alternative in the document of a plan.
/// `document`  the document of the alternative's own plan
[[nodiscard]] nlohmann::json alternative_json(const planning::Alternative& alternative,
                                              const nlohmann::json& document);

/// The alternatives in the document of a plan, one line each: name, id, arrival, travel time, distance, and
/// what it leads around. Empty if none were requested.
[[nodiscard]] std::vector<std::string> alternative_lines(const nlohmann::json& plan_document);

}  // namespace floeplan::codec
