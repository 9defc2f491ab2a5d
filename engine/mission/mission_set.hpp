#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/goto_lists.hpp"
#include "engine/mission/mission_file.hpp"
#include "engine/mission/shoals.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// Version of the firmware that shall read the files.
struct Firmware {
  int major{10};
  int minor{5};

  friend auto operator<=>(const Firmware&, const Firmware&) = default;
};

/// What work under ice needs besides the plan.
struct UnderIce {
  std::vector<geo::LonLat> safe_places;  // open water to head for in an emergency, one to eight
  /// Default: as deep as what the plan passes below, or as in the vendor's stock settings where that is deeper.
  std::optional<core::Metres> deepest_expected_iceberg{};
  core::Metres margin_below_ice{planning::UnderIceRules{}.margin_below_ice};  // that the plan was made with
};

struct MissionSetOptions {
  GotoListOptions lists{};           // `first_number` numbers the other files too
  std::string name{"plan"};          // of the mission, without its ending
  vehicle::GliderProfile vehicle{};  // with the depth to dive to
  Firmware firmware{};
  std::optional<UnderIce> under_ice{};
  /// That the plan was asked to surface at; in open water the mission comes up as often.
  std::optional<core::Seconds> surfacing_interval{};
  std::vector<std::optional<Shoal>> shoals{};  // of each leg, as shoals_along gives them; empty: not known
};

/// Writes all that a vehicle needs to fly the plan: a mission, the goto lists, and an argument file each for yo,
/// sample and prepare_to_dive and for three or four surfacings.
/// Values   depths, altitude, pitch and pump come from vehicle and plan; waiting times and the order of behaviors are
///          those of the vendor's stock missions; what neither gives is left to the vehicle's dictionary. No
///          factory setting (f_...) and no calibration is ever written.
/// Depth    the target stays 2 % and at least 3 m above the rating, since a glider overshoots and aborts at its working
///          depth
/// Ice      a plan that passes below ice or icebergs needs `under_ice`, and its yo climbs no higher than the deepest
///          turn that they ask for anywhere, on all its legs. No surfacing at waypoints; the list of safe places that
///          the stock recovery mission flies (goto_l98.ma), the settings for ice in the mission, and once more as
///          `ice_NN.mi` to be loaded alone
/// Thruster on for all dives and climbs, at the input power of the vehicle profile, where the plan runs on it from
/// start to
///          goal; one yo cannot run it on some legs alone: then off, with a warning that names them
/// Shoals   one yo is flown on the whole way: refused where the sea on it leaves that no room to turn above the bed by
///          the altimeter's margin, as a yo that keeps below ice has none over a bank in open water
/// Errors   every violation at once; those of write_goto_lists too
/// Threads  may be called from several threads at once
[[nodiscard]] tl::expected<MissionFiles, core::Violations> write_mission_set(
    const planning::Plan& plan, const MissionSetOptions& options);

}  // namespace floeplan::mission
