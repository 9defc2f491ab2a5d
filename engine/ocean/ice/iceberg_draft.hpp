#pragma once

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"

namespace floeplan::ocean {

/// Draft for passing under the berg: the stated one, otherwise the largest for its `safe_length`.
/// Source   draft = 2.91 L^0.71 for L <= 160 m: Barker, Sayed and Carrieres 2004, Determination of iceberg
///          draft, mass and cross-sectional areas, ISOPE; 3.78 L^0.63 beyond: Hotzel and Miller 1983,
///          Icebergs: their physical dimensions, Ann. Glaciol. 4, but at least the former at 160 m
[[nodiscard]] core::Metres safe_draft(const Iceberg& iceberg);

/// Draft for the drift: the stated one, otherwise the one of operational drift forecasts. With too large a
/// draft the forecast would hold a berg aground that in fact drifts on.
/// Source   draft = 1.78 L^0.71: C-CORE, from iceberg profiles off Newfoundland, used for its forecasts
///          2023-24
[[nodiscard]] core::Metres drift_draft(const Iceberg& iceberg);

}  // namespace floeplan::ocean
