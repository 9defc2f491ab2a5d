#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/file_origin.hpp"
#include "engine/mission/mission_file.hpp"
#include "engine/planning/plan.hpp"

namespace floeplan::mission {

/// The plan as a Seaglider `targets` file: every place but the start, each leading to the next, the last to itself.
/// `radius`  within which a target is reached
/// Frame     packed degrees and minutes, latitude first, WGS84
/// Source    iop-apl-uw/basestation3 validate.py, the checks of a targets file
/// Errors    std::invalid_argument for a plan of fewer than two waypoints
[[nodiscard]] MissionFile write_targets(const planning::Plan& plan, core::Metres radius,
                                        const FileOrigin& origin);

/// The places of a targets file in the order in which its first target leads to the others.
/// Errors   each line that cannot be read, targets that are named but not there, targets without a place
[[nodiscard]] tl::expected<std::vector<geo::LonLat>, core::Violations> read_targets(std::string_view text);

}  // namespace floeplan::mission
