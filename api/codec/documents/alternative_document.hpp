#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/planning/problem/alternative.hpp"

namespace floeplan::codec {

/// What the document of a plan says of an alternative to it.
/// `document`  of the alternative's own plan
[[nodiscard]] nlohmann::json alternative_json(const planning::Alternative& alternative,
                                              const nlohmann::json& document);

/// What the document of a plan says of its alternatives, as a line for each: name, id, arrival, travel time, distance, and
/// round what it leads. Empty where none were asked for.
[[nodiscard]] std::vector<std::string> alternative_lines(const nlohmann::json& plan_document);

}  // namespace floeplan::codec
