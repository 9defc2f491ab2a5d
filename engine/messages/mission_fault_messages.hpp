#pragma once

#include <string>
#include <utility>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Why a plan cannot be written as files for a vehicle, and why mission files and logs cannot be flown in the simulator.
/// Each text follows the name of the field, file or line. None has a rank of its own: what is refused endangers nobody.
namespace floeplan::messages {

inline constexpr auto mission_fault_kinds = std::to_array<Kind>({
    // The files of a mission.
    {.code = "wrong-mission-name", .text = "must have one to eight small letters, digits or underscores"},
    {.code = "mission-on-board",
     .text = "must not be {name}, a mission that every vehicle has on board",
     .slots = {{{"name", "stock"}}}},
    {.code = "wrong-firmware", .text = "must be a version from 7.0 to 11.99"},
    {.code = "firmware-without-ice",
     .text = "must be 10.0 or later for work under ice: older ones have no response to it"},
    {.code = "file-numbers-used-up",
     .text = "the files take the numbers from the given one on to {last}; all must lie between 0 and 97 (98 "
             "and 99 belong to the firmware)",
     .slots = {{{"last", 103}}}},
    {.code = "list-numbers-used-up",
     .text =
         "the plan takes {lists} list(s), numbered from the given number on; all numbers must lie between "
         "0 and 97 (98 and 99 belong to the firmware)",
     .slots = {{{"lists", 12}}}},
    {.code = "wrong-glider-name",
     .text = "must be one to 40 letters, digits and underscores, the name of a folder"},

    // Waypoints and lists.
    {.code = "no-start-and-goal", .text = "a plan to export has at least a start and a goal"},
    {.code = "waypoint-near-pole",
     .text = "must be a place between 89 degrees south and 89 degrees north; nearer to a pole the vehicle "
             "cannot navigate by longitude and latitude"},
    {.code = "wrong-waypoint-radius", .text = "must be between 10 m, the vehicle's minimum, and 100 km"},
    {.code = "no-such-row", .text = "must be -2, -1 or a row of the first list, counted from 0"},
    {.code = "legs-of-another-program",
     .text = "stands for a parameter that another program on board sets: which rows are flown is not known"},
    {.code = "wrong-legs-to-run",
     .text = "must be from 1 to {most}, -1 (round and round) or -2 (once)",
     .slots = {{{"most", 1000}}}},
    {.code = "wrong-initial-waypoint",
     .text = "must be a row of the list counted from 0, -1 (the one after the last achieved) or -2 (the "
             "closest); the list has {rows} {rows:row|rows}",
     .slots = {{{"rows", 8}}}},
    {.code = "too-many-waypoints-for-nmea",
     .text = "must be {most} at most for NMEA",
     .slots = {{{"most", 999}}}},

    // Ends of lists at ice and icebergs.
    {.code = "plan-ends-near-ice",
     .text = "is the end of the plan, {room}: extend the plan until it is more than {radius_m:.0f} m beyond "
             "them",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1600 m)"},
                {"radius_m", 500.0}}}},
    {.code = "list-ends-near-ice",
     .text = "is where a list has to end, {room}: extend the plan until it is more than {radius_m:.0f} m "
             "beyond them, or use fewer waypoints before it",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1600 m)"},
                {"radius_m", 500.0}}}},
    {.code = "plan-ends-below-ice",
     .text = "is the end of the plan and lies below ice or icebergs, but the vehicle surfaces at the end of "
             "its list: extend the plan to open water"},
    {.code = "too-many-waypoints-below-ice",
     .text = "are too many below ice or icebergs in a row: {waypoints} lie there, a list holds {most}, and "
             "the vehicle surfaces at the end of each list; plan again with fewer waypoints "
             "(--max-waypoints) or longer legs (--max-leg)",
     .slots = {{{"waypoints", "waypoints 3 to 14"}, {"most", 8}}}},
    {.code = "turns-of-earlier-version",
     .text =
         "is a plan of an older version that passes where the vehicle must not surface, without the depth "
         "where its dives turn there: plan again"},
    {.code = "safe-places-required",
     .text = "is required, with safe places in open water: the plan passes below ice or icebergs, where the "
             "vehicle must not surface"},

    // Safe places and the iceberg to expect.
    {.code = "wrong-number-of-safe-places",
     .text = "must name one to eight places in open water that the vehicle can recover to"},
    {.code = "safe-place-near-pole", .text = "must be a place between 89 degrees south and north"},
    {.code = "safe-place-on-land",
     .text = "must be open water that the vehicle can recover to: {place} is on land",
     .slots = {{{"place", "69.2000 N 53.2000 W"}}}},
    {.code = "safe-place-too-shallow",
     .text =
         "must be open water that the vehicle can recover to: {place} has {bed_m:.0f} m of water, and the "
         "vehicle needs {needed_m:.0f} m",
     .slots = {{{"place", "69.2000 N 53.2000 W"}, {"bed_m", 12.0}, {"needed_m", 20.0}}}},
    {.code = "safe-place-in-ice",
     .text = "must be open water that the vehicle can recover to: {place} has {ice_pct:.0f} % of ice while "
             "the plan lasts, and the vehicle surfaces in {most_pct:.0f} % at most",
     .slots = {{{"place", "69.2000 N 53.2000 W"}, {"ice_pct", 40.0}, {"most_pct", 10.0}}}},
    {.code = "safe-place-in-zone",
     .text = "must be open water that the vehicle can recover to: {place} lies in the no-go area {zone}",
     .slots = {{{"place", "69.2000 N 53.2000 W"}, {"zone", "Harbour"}}}},
    {.code = "safe-place-at-iceberg",
     .text =
         "must be open water that the vehicle can recover to: {place} is where iceberg {iceberg} was seen "
         "last",
     .slots = {{{"place", "69.2000 N 53.2000 W"}, {"iceberg", "B-17"}}}},
    {.code = "safe-place-too-far",
     .text = "must be open water that the vehicle can recover to: {place} is {away_km:.0f} km away from the "
             "plan, farther than the rest of the battery carries the vehicle",
     .slots = {{{"place", "69.2000 N 53.2000 W"}, {"away_km", 240.0}}}},
    {.code = "wrong-iceberg-depth", .text = "must be more than 0 m and less than the depth to dive to"},
    {.code = "iceberg-depth-too-small",
     .text = "must be {keel_m:.0f} m at least, as deep as what the plan passes below reaches",
     .slots = {{{"keel_m", 120.0}}}},

    // The yo.
    {.code = "no-room-for-yo",
     .text = "leaves a yo that turns at {dive_m:.0f} m no room, for it must turn no higher than {turn}",
     .slots = {{{"dive_m", 80.0}, {"turn", "75 m, below ice or icebergs"}}}},
    {.code = "water-too-shallow-for-yo",
     .text = "lead over water of {bed_m:.0f} m at {place}, before waypoint {waypoint}. The mission has "
             "one yo for all legs, which must turn no higher than {turn}, so it needs {needed_m:.0f} m of "
             "water. Plan again with via points round this water, or with a minimum working depth "
             "(minimum_working_depth_m) of {needed_m:.0f} for the vehicle; below ice that depth counts from "
             "the upper turn",
     .slots = {{{"bed_m", 60.0},
                {"place", "69.2000 N 53.2000 W"},
                {"waypoint", 3},
                {"turn", "40 m"},
                {"needed_m", 75.0}}}},
    {.code = "water-too-shallow-for-yo-below-ice",
     .text = "lead over water of {bed_m:.0f} m at {place}, before waypoint {waypoint}. The mission has "
             "one yo for all legs, which must turn no higher than {turn}, so it needs {needed_m:.0f} m of "
             "water. Plan again with via points round this water, or with a minimum working depth "
             "(minimum_working_depth_m) of {needed_m:.0f} for the vehicle; below ice that depth counts from "
             "the upper turn. Or fly two plans, one over this water and one below the ice, each with a yo of "
             "its own",
     .slots = {{{"bed_m", 60.0},
                {"place", "69.2000 N 53.2000 W"},
                {"waypoint", 3},
                {"turn", "40 m, below ice or icebergs"},
                {"needed_m", 75.0}}}},
    {.code = "not-flown-by-yo",
     .text = "cannot be flown {how}; {instead}",
     .slots = {{{"how",
                 "by the one yo of the mission, which turns between 90 m and 196 m on the whole route, "
                 "before waypoint 3: the route comes too close to an iceberg"},
                {"instead", "plan again with a climb_to_m of 90"}}}},

    // Seagliders.
    {.code = "too-deep-for-seaglider", .text = "must be 1100 m at most, the deepest a Seaglider is sent"},
    {.code = "dives-of-wrong-length",
     .text = "must give dives of 5 to 2880 minutes, not of {dive_min:.0f}",
     .slots = {{{"dive_min", 4000.0}}}},
    {.code = "seaglider-below-ice",
     .text = "must not be that of a Seaglider, which comes up after every dive: the plan passes below ice or "
             "icebergs"},
    {.code = "science-band-refused",
     .text = "{finding}",
     .slots = {{{"finding", "sensors must be given, one digit for each sensor"}}}},
});

/// What a row says of a field of an export, of a mission file or of a log.
template <Code code, class... Given>
[[nodiscard]] core::Violation mission_fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<mission_fault_kinds, code>(values...));
}

}  // namespace floeplan::messages
