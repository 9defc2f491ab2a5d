#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::codec {

/// Two stored plans side by side: the figures of each, what the second has more than the first, the inputs in which
/// they differ and the data that one of them alone was made with.
/// Errors   std::runtime_error when a stored document is not one
[[nodiscard]] nlohmann::json plan_comparison(const repository::PlanRecord& first,
                                             const repository::PlanRecord& second);

}  // namespace floeplan::codec
