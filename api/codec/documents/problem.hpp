#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/problems/problem.hpp"

namespace floeplan::codec {

/// As RFC 9457 has it. Its texts may hold what a client sent: long words are cut to their beginning, and credentials are
/// hidden.
[[nodiscard]] nlohmann::json to_json(const problems::Problem& problem);

}  // namespace floeplan::codec
