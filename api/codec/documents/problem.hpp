#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/problems/problem.hpp"

namespace floeplan::codec {

/// The problem as RFC 9457 defines it. Its texts may hold what a client sent: long words are cut, and credentials are
/// hidden.
[[nodiscard]] nlohmann::json to_json(const problems::Problem& problem);

}  // namespace floeplan::codec
