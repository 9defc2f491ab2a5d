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

/// Why no Seaglider may fly the plan: it comes up after every dive, and the plan passes below ice or icebergs, or does
/// not tell whether it does.
[[nodiscard]] std::optional<core::Violation> closed_to_seagliders(const planning::Plan& plan);

/// The plan as a Seaglider `targets` file: every place but the start, each leading to the next, the last to itself.
/// `radius`  within which a target is reached
/// Frame     packed degrees and minutes, latitude first, WGS84
/// Source    iop-apl-uw/basestation3 validate.py, the checks of a targets file
/// Errors    std::invalid_argument for a plan of fewer than two waypoints
[[nodiscard]] MissionFile write_targets(const planning::Plan& plan, core::Metres radius,
                                        const FileOrigin& origin);

struct SeagliderOptions {
  vehicle::GliderProfile vehicle{};  // with the depth to dive to
  std::vector<ScienceBand> bands{};  // from the surface down; none: no science file
  FileOrigin origin{};
  std::vector<std::optional<Shoal>> shoals{};  // of each leg, as shoals_along gives them; empty: not known
};

/// What a Seaglider needs to fly the plan: `targets`; a `cmdfile` with the depth and the time of a dive and the
/// directive to carry on as before; and a `science` file where bands are given, since which sensors a vehicle has is
/// known to its pilot alone.
/// Values    $D_TGT is the depth of the plan's dives, $T_DIVE how long one takes at the vehicle's rate of depth, both
///           rounded up to whole metres and minutes. Nothing else is set. A warning names the shoalest water where it
///           is shoaler than $D_TGT and the altimeter's margin
/// Source    iop-apl-uw/basestation3 validate.py and parmdata.py
/// Errors    every violation at once: a plan without a leg, or that passes below ice or icebergs, a depth or time that
///           no Seaglider takes, faulty bands
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_seaglider_set(
    const planning::Plan& plan, const SeagliderOptions& options);

/// "200:10:1110:120", a band of a science file: depth in metres (or the word loiter), seconds between samples, a digit
/// for each sensor, seconds between looks at the course. Nothing for any other text.
[[nodiscard]] std::optional<ScienceBand> parse_science_band(std::string_view text);

}  // namespace floeplan::mission
