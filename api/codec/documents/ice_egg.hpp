#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "storage/repository/features/ice_chart_repository.hpp"

namespace floeplan::codec {

/// The egg code of a polygon of an ice chart: its codes, and in words all its ice (`total`) and each part
/// (concentration, stage of development with thickness, form), the oldest ice first as in charts. A code that
/// is not in the tables stands for itself; what the chart leaves open is null.
/// Source   WMO/TD-No. 1214 (SIGRID-3): tables of concentration, stage of development and form of ice
[[nodiscard]] nlohmann::json ice_egg(const std::vector<repository::IceCode>& codes);

}  // namespace floeplan::codec
