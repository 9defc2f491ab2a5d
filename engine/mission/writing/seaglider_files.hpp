#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/mission/writing/file_origin.hpp"
#include "engine/mission/writing/mission_file.hpp"
#include "engine/mission/writing/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// Why a Seaglider must not fly the plan: it surfaces after every dive, and the plan passes below ice or
/// icebergs, or does not say whether it does. Empty if a Seaglider may fly the plan.
[[nodiscard]] std::optional<core::Violation> closed_to_seagliders(const planning::Plan& plan);

/// The plan as a Seaglider `targets` file: every place except the start. Each leads to the next, the last to
/// itself.
/// `radius`  within which a target counts as reached
/// Frame     packed degrees and minutes, latitude first, WGS84
/// Source    iop-apl-uw/basestation3 validate.py, the checks of a targets file
/// Errors    std::invalid_argument for a plan of fewer than two waypoints
[[nodiscard]] MissionFile write_targets(const planning::Plan& plan, core::Metres radius,
                                        const FileOrigin& origin);

struct SeagliderOptions {
  vehicle::GliderProfile vehicle{};  // with the dive depth
  std::vector<ScienceBand> bands{};  // from the surface down; empty: no science file
  FileOrigin origin{};
  std::vector<std::optional<Shoal>> shoals{};  // for each leg, from shoals_along; empty: unknown
};

/// The files that a Seaglider needs to fly the plan: `targets`; a `cmdfile` with depth and duration of a dive
/// and the directive to resume; and a `science` file if bands are given, because only the pilot knows the
/// vehicle's sensors.
/// Values    $D_TGT is the depth of the plan's dives, $T_DIVE the duration of a dive at the vehicle's vertical
///           speed, rounded up to whole metres and minutes. No other parameter is set. A warning names the
///           shoalest water if it is shoaler than $D_TGT plus the altimeter's margin
/// Source    iop-apl-uw/basestation3 validate.py and parmdata.py
/// Errors    every violation at once: a plan without a leg, or one that passes below ice or icebergs, a depth
///           or duration that no Seaglider accepts, invalid bands
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_seaglider_set(
    const planning::Plan& plan, const SeagliderOptions& options);

/// Parses a band of a science file such as "200:10:1110:120": depth in metres (or the word loiter), seconds
/// between samples, one digit per sensor, seconds between corrections of the course. Empty for any other
/// text.
[[nodiscard]] std::optional<ScienceBand> parse_science_band(std::string_view text);

}  // namespace floeplan::mission
