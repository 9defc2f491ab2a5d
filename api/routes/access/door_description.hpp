#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "api/routes/request/router.hpp"

namespace floeplan::routes {

/// Adds to an OpenAPI document, for each of these operations, what it takes to be let in: the schemes of security, the
/// least role ("x-role"), and the answers of whoever is not (401, 403, 429). Taken from the operations themselves, so
/// that nobody has to keep the two alike.
void describe_doors(nlohmann::json& document, const std::vector<Route>& routes);

}  // namespace floeplan::routes
