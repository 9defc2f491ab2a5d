#pragma once

#include <string>
#include <utility>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Why a plan cannot be written as files for a vehicle, and why mission files and logs cannot be flown in the
/// simulator. Each text follows the name of the field, file or line. They have no rank: what is refused
/// endangers no vehicle.
namespace floeplan::messages {

inline constexpr auto mission_fault_kinds = std::to_array<Kind>({
    // The files of a mission.
    {.code = "wrong-mission-name",
     .text = "must have one to eight lower-case letters, digits or underscores"},
    {.code = "mission-on-board",
     .text = "must not be {name}, because every vehicle has a mission of this name on board",
     .hint = "choose another name",
     .slots = {{{"name", "stock"}}}},
    {.code = "wrong-firmware", .text = "must be a version from 7.0 to 11.99"},
    {.code = "firmware-without-ice",
     .text = "must be 10.0 or later for work under ice, because older firmware has no response to ice",
     .hint = "update the firmware, or plan a route in open water"},
    {.code = "file-numbers-used-up",
     .text = "gives the files numbers up to {last}, but all must lie between 0 and 97 (98 and 99 belong to "
             "the firmware); choose a smaller number",
     .slots = {{{"last", 103}}}},
    {.code = "list-numbers-used-up",
     .text = "is too large, because the plan takes {lists} {lists:list|lists} with rising numbers. All "
             "must lie between 0 and 97 (98 and 99 belong to the firmware)",
     .hint = "choose a smaller number",
     .slots = {{{"lists", 12}}}},
    {.code = "wrong-glider-name",
     .text = "must be the name of a folder: one to 40 letters, digits and underscores"},

    // Waypoints and lists.
    {.code = "no-start-and-goal", .text = "must have at least a start and a goal"},
    {.code = "waypoint-near-pole",
     .text = "must be a place between 89 degrees south and 89 degrees north, because the vehicle cannot "
             "navigate by longitude and latitude nearer to a pole"},
    {.code = "wrong-waypoint-radius", .text = "must be between 10 m, the vehicle's minimum, and 100 km"},
    {.code = "no-such-row",
     .text = "must be -2, -1 or the number of a row of the first list, counted from 0"},
    {.code = "legs-of-another-program",
     .text = "stands for a value that another program on board sets, so the rows to be flown are not "
             "known",
     .hint = "give the number of rows itself"},
    {.code = "wrong-legs-to-run",
     .text = "must be from 1 to {most}, -1 (round and round without end) or -2 (once)",
     .slots = {{{"most", 1000}}}},
    {.code = "wrong-initial-waypoint",
     .text = "must be the number of a row counted from 0, -1 (the row after the last one reached) or -2 (the "
             "closest row). The list has {rows} {rows:row|rows}",
     .slots = {{{"rows", 8}}}},
    {.code = "too-many-waypoints-for-nmea",
     .text = "must hold at most {most} waypoints for NMEA",
     .hint = "plan with fewer waypoints (--max-waypoints)",
     .slots = {{{"most", 999}}}},

    // Lists that end near ice and icebergs.
    {.code = "plan-ends-near-ice",
     .text = "is the end of the plan, only {room}. The vehicle surfaces there, perhaps below the ice; "
             "extend the plan until it ends more than {radius_m:distance} beyond the ice",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1.6 km)"},
                {"radius_m", 500.0}}}},
    {.code = "list-ends-near-ice",
     .text = "is the end of a list, only {room}. The vehicle surfaces there, perhaps below the ice; "
             "extend the plan until it goes more than {radius_m:distance} beyond the ice, or use fewer "
             "waypoints before it",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1.6 km)"},
                {"radius_m", 500.0}}}},
    {.code = "plan-ends-below-ice",
     .text = "is the end of the plan and lies below ice or icebergs, but the vehicle surfaces at the end of "
             "its list; extend the plan to open water"},
    {.code = "too-many-waypoints-below-ice",
     .text = "are too many below ice or icebergs, where {waypoints} lie. A list holds only {most}, and the "
             "vehicle surfaces at the end of each list; plan again with fewer waypoints (--max-waypoints) or "
             "longer legs (--max-leg)",
     .slots = {{{"waypoints", "waypoints 3 to 14"}, {"most", 8}}}},
    {.code = "turns-of-earlier-version",
     .text = "is a plan of an older version that passes water where the vehicle must not surface. The plan "
             "lacks the upper turn of its dives there; plan again"},
    {.code = "safe-places-required",
     .text = "is required: name safe places in open water, because the plan passes below ice or icebergs, "
             "where the vehicle must not surface"},

    // Safe places, and the draft of icebergs to expect.
    {.code = "wrong-number-of-safe-places",
     .text = "must name one to eight safe places: open water that the vehicle can reach for recovery"},
    {.code = "safe-place-near-pole", .text = "must be a place between 89 degrees south and 89 degrees north"},
    {.code = "safe-place-on-land",
     .text = "must be open water that the vehicle can reach for recovery, but {place} is on land",
     .hint = "choose another place",
     .slots = {{{"place", "-53.2000, 69.2000"}}}},
    {.code = "safe-place-too-shallow",
     .text = "must be open water that the vehicle can reach for recovery, but "
             "{place} has only {bed_m:.0f} m of "
             "water, and the vehicle needs {needed_m:.0f} m",
     .hint = "choose another place",
     .slots = {{{"place", "-53.2000, 69.2000"}, {"bed_m", 12.0}, {"needed_m", 20.0}}}},
    {.code = "safe-place-in-ice",
     .text = "must be open water that the vehicle can reach for recovery, but "
             "{place} has {ice_pct:.0f} % of "
             "ice during the plan, and the vehicle surfaces in at most {most_pct:.0f} %",
     .hint = "choose another place",
     .slots = {{{"place", "-53.2000, 69.2000"}, {"ice_pct", 40.0}, {"most_pct", 10.0}}}},
    {.code = "safe-place-in-zone",
     .text = "must be open water that the vehicle can reach for recovery, but "
             "{place} lies in the no-go area "
             "{zone}",
     .hint = "choose another place",
     .slots = {{{"place", "-53.2000, 69.2000"}, {"zone", "Harbour"}}}},
    {.code = "safe-place-at-iceberg",
     .text = "must be open water that the vehicle can reach for recovery, but "
             "iceberg {iceberg} was last seen "
             "at {place}",
     .hint = "choose another place",
     .slots = {{{"place", "-53.2000, 69.2000"}, {"iceberg", "B-17"}}}},
    {.code = "safe-place-too-far",
     .text = "must be open water that the vehicle can reach for recovery, but "
             "{place} is {away_km:distance} from "
             "the plan, farther than the rest of the battery carries the vehicle",
     .hint = "choose a nearer place",
     .slots = {{{"place", "-53.2000, 69.2000"}, {"away_km", 240.0}}}},
    {.code = "wrong-iceberg-depth", .text = "must be more than 0 m and less than the dive depth"},
    {.code = "iceberg-depth-too-small",
     .text = "must be at least {keel_m:.0f} m, the depth of the deepest keel that the plan passes under",
     .slots = {{{"keel_m", 120.0}}}},

    // The yo.
    {.code = "no-room-for-yo",
     .text = "leaves the yo no room. It dives only to {dive_m:.0f} m, but its upper turn must be no "
             "shallower than {turn}",
     .hint = "plan again with deeper dives (--dive-depth)",
     .slots = {{{"dive_m", 80.0}, {"turn", "75 m because of ice or icebergs"}}}},
    {.code = "water-too-shallow-for-yo",
     .text = "lead over water of only {bed_m:.0f} m at {place}, before waypoint {waypoint:label}. The "
             "mission has one yo for all legs. Its upper turn must be no shallower than {turn}, so it "
             "needs {needed_m:.0f} m of water. Plan again with via points round this water, or raise "
             "the minimum working depth of the vehicle to {needed_m:.0f} m (minimum_working_depth_m), "
             "which below ice counts from the upper turn",
     .slots = {{{"bed_m", 60.0},
                {"place", "-53.2000, 69.2000"},
                {"waypoint", 3},
                {"turn", "40 m"},
                {"needed_m", 75.0}}}},
    {.code = "water-too-shallow-for-yo-below-ice",
     .text = "lead over water of only {bed_m:.0f} m at {place}, before waypoint {waypoint:label}. The "
             "mission has one yo for all legs. Its upper turn must be no shallower than {turn}, so it "
             "needs {needed_m:.0f} m of water. Plan again with via points round this water, or raise "
             "the minimum working depth of the vehicle to {needed_m:.0f} m (minimum_working_depth_m), "
             "which below ice counts from the upper turn. Or fly two plans, one over this water and "
             "one below the ice, each with a yo of its own",
     .slots = {{{"bed_m", 60.0},
                {"place", "-53.2000, 69.2000"},
                {"waypoint", 3},
                {"turn", "40 m because of ice or icebergs"},
                {"needed_m", 75.0}}}},
    {.code = "not-flown-by-yo",
     .text = "cannot be flown {how}; {instead}",
     .slots = {{{"how",
                 "by the one yo of the mission, which turns between 90 m and 196 m on the whole "
                 "route. Before waypoint 3, the route comes too close to an iceberg"},
                {"instead", "plan again with an upper turn at 90 m (--climb-to 90)"}}}},

    // Seagliders.
    {.code = "too-deep-for-seaglider", .text = "must be at most 1100 m, because no Seaglider dives deeper"},
    {.code = "dives-of-wrong-length",
     .text = "must give dives of 5 to 2880 minutes, not of {dive_min:.0f} minutes",
     .hint = "choose another dive depth or vertical speed",
     .slots = {{{"dive_min", 4000.0}}}},
    {.code = "seaglider-below-ice",
     .text = "must not be that of a Seaglider, because the plan passes below ice or icebergs and a "
             "Seaglider surfaces after every dive",
     .hint = "choose another vehicle, or plan a route in open water"},
    {.code = "science-band-refused",
     .text = "{finding}",
     .slots = {{{"finding", "sensors must be given, one digit for each sensor"}}}},
});

/// The violation of a field of an export, a mission file or a log, with the text of this row.
template <Code code, class... Given>
[[nodiscard]] core::Violation mission_fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<mission_fault_kinds, code>(values...));
}

}  // namespace floeplan::messages
