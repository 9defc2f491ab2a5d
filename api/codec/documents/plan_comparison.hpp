#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::codec {

/// Compares two stored plans: the values of each, the differences (second minus first), the inputs that
/// differ, and the data that only one of them used.
/// Errors   std::runtime_error when a stored document is not a plan
[[nodiscard]] nlohmann::json plan_comparison(const repository::PlanRecord& first,
                                             const repository::PlanRecord& second);

}  // namespace floeplan::codec
