#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/mission/document/document.hpp"
#include "engine/mission/document/flown_rows.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// A goto list: where to steer for.
struct GotoOrders {
  std::vector<geo::LonLat> waypoints;
  core::Metres radius{10.0};                           // in which a waypoint counts as reached
  mission::ListOrders rows{.legs = -2, .initial = 0};  // which of them are flown
  bool next_on_board{};                                // the next list follows without a time at the surface
  std::optional<mission::HoldOrder> hold{};            // of a list that keeps the vehicle at a place
};

/// Half of a yo: what the vehicle does to get to its next turn.
struct HalfYo {
  core::Metres depth{};                    // to turn at
  std::optional<core::Metres> altitude{};  // above the sea bed to turn at, if that comes first
  double pitch_rad{};                      // nose up positive
  double buoyancy_m3{};                    // up positive, no more than the pump moves
  bool thruster{};
};

struct YoOrders {
  HalfYo dive{};
  HalfYo climb{};
  int half_cycles{-1};  // to do; negative: for ever
  bool dives_first{true};
};

/// A surface behaviour: why the vehicle comes up, and what it does there.
/// Source   the codes of start_when and end_action are those of the vendor's data dictionary of firmware 10.5
struct SurfaceOrders {
  enum class Cause {
    any_idle,       // 1: list or yo has ended
    yo_idle,        // 2 and 4: the yo has ended
    list_idle,      // 3: the list has ended
    after_end,      // 6: so long after the last time up
    near_waypoint,  // 7
    waypoint_hit,   // 8
    every,          // 9 and 10: so long after the last time it began
    no_contact,     // 12
    inflections     // 16: more than so many turns since the last time up
  };
  Cause cause{};
  core::Seconds interval{};  // of after_end, every and no_contact
  core::Metres distance{};   // of near_waypoint
  int turns{};               // of inflections
  bool ends_mission{};       // end_action 0
  core::Seconds wait{};      // for the pilot, after the fix
  HalfYo climb{};            // to the surface
};

/// What the mission files of a Slocum order, behaviour by behaviour.
struct MissionOrders {
  std::string name;               // of the mission or of its first file
  std::vector<GotoOrders> lists;  // flown one after the other; the next is sent when one is flown
  YoOrders yo{};
  std::vector<SurfaceOrders> surfaces;         // in order of priority
  bool corrects_for_current{true};             // u_use_current_correction
  std::optional<core::Metres> overdepth{};     // of abend: deeper aborts
  std::optional<core::Seconds> same_depth{};   // of abend: so long at one depth aborts
  std::optional<core::Metres> max_waypoint{};  // of abend: a farther waypoint aborts
  std::vector<std::string> notes;              // what is not simulated or was filled in, for the pilot
};

/// Reads the orders of a whole mission: a `.mi` with all argument files that it names, or argument files alone, in
/// which case a yo as in the profile and a surfacing at the end of the list stand in for those missing. Where several
/// goto lists are given, they are flown one after the other, as a pilot sends them while the vehicle is up; of a
/// mission the one that it names and those numbered on from it, up to the numbers of the firmware.
/// Vehicle  a depth or a pump volume beyond the vehicle, a thruster that it has not, files of another make: refused
/// Errors   every violation at once: rejected documents by their errors, files that are named and missing, no list, a
///          reason to come up that is not simulated
[[nodiscard]] tl::expected<MissionOrders, core::Violations> read_orders(
    std::span<const mission::Document> documents, const vehicle::GliderProfile& vehicle);

}  // namespace floeplan::simulation
