#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/problems/problem.hpp"

namespace floeplan::codec {

/// The problem as an RFC 9457 document. Its texts may contain input of a client, so long words are cut and
/// credentials hidden.
[[nodiscard]] nlohmann::json to_json(const problems::Problem& problem);

}  // namespace floeplan::codec
