#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/planning/problem/alternative.hpp"

namespace floeplan::codec {

/// What the document of a plan says of an alternative to it.
/// `document`  of the alternative's own plan
[[nodiscard]] nlohmann::json alternative_json(const planning::Alternative& alternative,
                                              const nlohmann::json& document);

}  // namespace floeplan::codec
