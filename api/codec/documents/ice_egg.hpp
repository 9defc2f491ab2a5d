#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "storage/repository/features/ice_chart_repository.hpp"

namespace floeplan::codec {

/// The egg code of a polygon of an ice chart: its codes, and in words all the ice (`total`) and each part of it
/// (concentration, stage of development with its thickness, form), the oldest first as charts have them. Of a code that the
/// tables do not have the code itself stands for the words; what a chart leaves open is null.
/// Source   WMO/TD-No. 1214 (SIGRID-3): tables of concentration, stage of development and form of ice
[[nodiscard]] nlohmann::json ice_egg(const std::vector<repository::IceCode>& codes);

}  // namespace floeplan::codec
