#pragma once

#include "engine/core/units.hpp"
#include "engine/ocean/ice/iceberg.hpp"

namespace floeplan::ocean {

/// Draft to stay below when passing under: the stated one, else the largest that `safe_length` lets expect.
/// Source   draft = 2.91 L^0.71 for L <= 160 m: Barker, Sayed and Carrieres 2004, Determination of iceberg
///          draft, mass and cross-sectional areas, ISOPE; 3.78 L^0.63 beyond: Hotzel and Miller 1983, Icebergs:
///          their physical dimensions, Ann. Glaciol. 4, never less than the former at 160 m
[[nodiscard]] core::Metres safe_draft(const Iceberg& iceberg);

/// Draft to reckon the drift with: the stated one, else the one that operational drift forecasts use. A berg
/// taken to be deeper than it is would be held aground where it drifts on.
/// Source   draft = 1.78 L^0.71: C-CORE, from iceberg profiles off Newfoundland, used for its forecasts 2023-24
[[nodiscard]] core::Metres drift_draft(const Iceberg& iceberg);

}  // namespace floeplan::ocean
