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

/// The orders of a goto list: waypoints to steer for.
struct GotoOrders {
  std::vector<geo::LonLat> waypoints;
  core::Metres radius{10.0};                           // within which a waypoint counts as reached
  mission::ListOrders rows{.legs = -2, .initial = 0};  // which rows are flown
  bool next_on_board{};                                // the next list follows without a surfacing
  std::optional<mission::HoldOrder> hold{};            // of a list that is a hold
};

/// Half of a yo: the orders until the next turn of the saw-tooth.
struct HalfYo {
  core::Metres depth{};                    // to turn at
  std::optional<core::Metres> altitude{};  // height above the sea bed at which to turn, if that comes first
  double pitch_rad{};                      // nose up positive
  double buoyancy_m3{};                    // up positive, within the range of the pump
  bool thruster{};
};

struct YoOrders {
  HalfYo dive{};
  HalfYo climb{};
  int half_cycles{-1};  // number to do; negative: without end
  bool dives_first{true};
};

/// A surface behavior: why the vehicle surfaces, and what it does there.
/// Source   the codes of start_when and end_action are those of the vendor's data dictionary of firmware 10.5
struct SurfaceOrders {
  enum class Cause {
    any_idle,       // 1: the list or the yo has ended
    yo_idle,        // 2 and 4: the yo has ended
    list_idle,      // 3: the list has ended
    after_end,      // 6: `interval` after the end of this order's last surfacing
    near_waypoint,  // 7: the waypoint is nearer than `distance`
    waypoint_hit,   // 8: a waypoint was reached
    every,          // 9 and 10: `interval` after the begin of this order's last surfacing
    no_contact,     // 12: no contact for `interval`
    inflections     // 16: more than `turns` turns since the last surfacing
  };
  Cause cause{};
  core::Seconds interval{};  // for after_end, every and no_contact
  core::Metres distance{};   // for near_waypoint
  int turns{};               // for inflections
  bool ends_mission{};       // end_action 0
  core::Seconds wait{};      // for the pilot, after the fix
  HalfYo climb{};            // to the surface
};

/// The orders in the mission files of a Slocum, by behavior.
struct MissionOrders {
  std::string name;               // of the mission, or of its first file
  std::vector<GotoOrders> lists;  // in flown order; the pilot sends the next when one is flown
  YoOrders yo{};
  std::vector<SurfaceOrders> surfaces;         // in order of priority
  bool corrects_for_current{true};             // u_use_current_correction
  std::optional<core::Metres> overdepth{};     // of abend: abort below this depth
  std::optional<core::Seconds> same_depth{};   // of abend: abort after this time at one depth
  std::optional<core::Metres> max_waypoint{};  // of abend: abort if a waypoint is farther
  std::vector<std::string> notes;              // for the pilot: what is not simulated, or was added
};

/// Reads the orders of a whole mission: a `.mi` with all argument files that it names, or argument files
/// alone. In the second case a missing yo is taken from the profile, and a missing surfacing is one at the
/// end of the list. Several goto lists are flown one after another, as a pilot sends them at surfacings. Of a
/// mission these are the list that it names and those with the following numbers, up to the numbers of the
/// firmware.
/// Vehicle  refused: a depth or pump volume out of the vehicle's range, a thruster that it lacks, files of
///          another make
/// Errors   every violation at once: rejected documents by their errors, missing files, no list, a cause of
///          surfacing that is not simulated
[[nodiscard]] tl::expected<MissionOrders, core::Violations> read_orders(
    std::span<const mission::Document> documents, const vehicle::GliderProfile& vehicle);

}  // namespace floeplan::simulation
