#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot when a stored plan is checked again and written as files for a vehicle.
/// Ranks    danger: newer data close the plan; it must not be flown. Caution: the files lack something, or
///          differ from the plan, and the pilot must see to it. Note: good to know
namespace floeplan::messages {

inline constexpr auto export_kinds = std::to_array<Kind>({
    // The plan checked with newer data.
    {.code = "closed-in-newest-data",
     .rank = Rank::danger,
     .text = "in the newest data, leg {leg} is closed: {found}",
     .hint = "Plan again",
     .slots = {{{"leg", 3}, {"found", "the route comes too close to an iceberg"}}}},
    {.code = "unknown-in-newest-data",
     .rank = Rank::caution,
     .text = "leg {leg} could not be checked in the newest data: {found}",
     .hint = "Ingest data that cover this leg, and check again",
     .slots = {{{"leg", 3}, {"found", "the stored data do not cover this place at this time"}}}},
    {.code = "ice-above-in-newest-data",
     .rank = Rank::danger,
     .text = "in the newest data, {found}",
     .hint = "Plan again",
     .slots = {{{"found", "the vehicle must not surface at waypoints 3 to 5, although the plan allows it"}}}},
    {.code = "sightings-too-old-for-plan",
     .rank = Rank::danger,
     .text = "{ignored} {ignored:iceberg was|icebergs were} ignored, because {ignored:its last sighting "
             "is|their last sightings are} too old at the departure of the plan. {ignored:The iceberg|Each} "
             "may still be near the route",
     .hint = "Ingest newer sightings and plan again",
     .slots = {{{"ignored", 2}}}},
    {.code = "clear-in-newest-data",
     .rank = Rank::note,
     .text = "the data have changed since the plan was made. In the newest data, no leg of the plan "
             "is closed"},
    {.code = "not-checked-in-data",
     .rank = Rank::caution,
     .text = "the plan could not be checked in the stored data, because {why}",
     .hint = "Ingest these data, and check again",
     .slots = {{{"why", "no stored dataset reaches 60° W to 58° W, 69° N to 70° N"}}}},
    {.code = "not-checked-by-this-version",
     .rank = Rank::caution,
     .text = "another version stored the plan, so it could not be checked in newer data",
     .hint = "Plan again before the flight"},
    {.code = "made-without-bathymetry",
     .rank = Rank::caution,
     .text = "the plan was made without bathymetry, so the depth of the water is not checked",
     .hint = "Ingest bathymetry and plan again, or check the depths on a nautical chart"},
    {.code = "made-without-ice",
     .rank = Rank::caution,
     .text = "the plan was made without sea ice, so open water is assumed",
     .hint = "If there may be ice on the route, ingest sea ice and plan again"},
    {.code = "made-without-icebergs",
     .rank = Rank::caution,
     .text = "the plan was made without icebergs, so it avoids none",
     .hint = "If there may be icebergs on the route, ingest sightings and plan again"},

    // Lists of waypoints.
    {.code = "several-lists",
     .rank = Rank::caution,
     .text = "the plan takes {lists} lists, {first} to {last}. A list has at most {most} "
             "{most:waypoint|waypoints} and ends earlier at a hold or at ice. The vehicle flies only the "
             "list that its mission names",
     .hint = "Send the next list when a list ends",
     .slots = {{{"lists", 3}, {"first", "goto_l10.ma"}, {"last", "goto_l12.ma"}, {"most", 8}}}},
    {.code = "lists-with-holds",
     .rank = Rank::caution,
     .text = "the plan takes {lists} lists, {first} to {last}, of which {holds} {holds:holds|hold} station. "
             "The vehicle flies only the list that its mission names",
     .hint = "Send the next list when a list ends",
     .slots = {{{"lists", 3}, {"holds", 1}, {"first", "goto_l10.ma"}, {"last", "goto_l12.ma"}}}},
    {.code = "list-ends-in-unknown-ice",
     .rank = Rank::caution,
     .text = "{list} ends at waypoint {waypoint:label}, where the ice is unknown",
     .hint = "Make sure that the vehicle can surface there",
     .slots = {{{"list", "goto_l10.ma"}, {"waypoint", 8}}}},
    {.code = "list-ends-far-off",
     .rank = Rank::caution,
     .text = "{list} ends at waypoint {waypoint:label} with a position error of {error_km:distance}",
     .hint =
         "Make sure that all water within this distance is open, or plan a surfacing before this waypoint",
     .slots = {{{"list", "goto_l10.ma"}, {"waypoint", 8}, {"error_km", 6.0}}}},
    {.code = "list-ends-after-ice-of-earlier-version",
     .rank = Rank::caution,
     .text = "{list} ends at waypoint {waypoint:label} after ice or icebergs. An older version stored the "
             "plan, without the distance of this waypoint from the ice",
     .hint = "Plan again before the flight",
     .slots = {{{"list", "goto_l10.ma"}, {"waypoint", 8}}}},
    // A caution only: the planned end lies in open water; the vehicle ends below ice only with a position
    // error as large as expected.
    {.code = "list-may-end-below-ice",
     .rank = Rank::caution,
     .text = "{list} ends at waypoint {waypoint:label}, {room}. The vehicle may therefore surface below the "
             "ice",
     .hint = "Plan the end more than {needed_m:distance} from the ice, or use a vehicle with smaller errors "
             "of dead reckoning and currents",
     .slots = {{{"list", "goto_l10.ma"},
                {"waypoint", 8},
                {"room", "900 m beyond the ice (waypoint radius 500 m, position error 1.6 km)"},
                {"needed_m", 1900.0}}}},
    {.code = "list-ends-beside-ice",
     .rank = Rank::caution,
     .text = "{list} ends at waypoint {waypoint:label}, {room}",
     .hint = "Make sure that all water within the waypoint radius and the position error is open",
     .slots = {{{"list", "goto_l10.ma"},
                {"waypoint", 8},
                {"room", "5.0 km beyond the ice (waypoint radius 500 m, position error 1.6 km)"}}}},
    {.code = "list-flown-longer",
     .rank = Rank::caution,
     .text = "{list} may take {late_h:duration} longer than planned, because the vehicle navigates with the "
             "current estimate of the list before it",
     .hint = "Make sure that the water at the end of this list is still open then",
     .slots = {{{"list", "goto_l11.ma"}, {"late_h", 5.6}}}},
    {.code = "long-before-first-surfacing",
     .rank = Rank::caution,
     .text = "{list} takes {flown_h:duration} to the first surfacing. Until then the vehicle navigates with "
             "the current estimate of its last mission, or without any estimate. Each 0.1 m/s of error "
             "carries the vehicle {off_km:distance} off the route, and perhaps below ice",
     .hint = "Order a short dive at the start, or send a list with only the first waypoint",
     .slots = {{{"list", "goto_l10.ma"}, {"flown_h", 8.0}, {"off_km", 2.9}}}},
    {.code = "lists-longer-than-documented",
     .rank = Rank::caution,
     .text = "the lists hold up to {most} {most:waypoint|waypoints}, but the vendor documents only 8",
     .hint = "Make sure that the firmware of this vehicle accepts longer lists",
     .slots = {{{"most", 12}}}},
    {.code = "waypoint-radius-too-large",
     .rank = Rank::caution,
     .text = "the waypoint radius of {radius_m:distance} is at least half of the shortest leg "
             "({shortest_m:distance}), so the vehicle may skip a waypoint",
     .hint = "Choose a smaller radius",
     .slots = {{{"radius_m", 500.0}, {"shortest_m", 800.0}}}},
    {.code = "corners-may-be-cut",
     .rank = Rank::caution,
     .text = "the vehicle turns up to {radius_m:distance} before a waypoint and may cut corners, but the "
             "plan passes {what} at {clearance_m:distance}",
     .hint = "Choose a smaller waypoint radius",
     .slots = {{{"radius_m", 500.0}, {"what", "an iceberg"}, {"clearance_m", 400.0}}}},
    {.code = "long-leg",
     .rank = Rank::caution,
     .text = "the leg to waypoint {waypoint:label} is {leg_km:distance} long. The vehicle aborts on a leg "
             "longer than the mission's max_wpt_distance",
     .hint = "Check this value",
     .slots = {{{"waypoint", 3}, {"leg_km", 140.0}}}},
    {.code = "hold-list",
     .rank = Rank::caution,
     .text = "{list} holds station at waypoint {waypoint:label} with {legs} legs between two rows. In the "
             "currents of the plan that takes about {expected_h:duration}",
     .hint =
         "Send {next} at the surfacing nearest to {release}. If {list} ends long before, send {list} again",
     .slots = {{{"list", "goto_l11.ma"},
                {"waypoint", 4},
                {"legs", 5},
                {"expected_h", 2.7},
                {"next", "goto_l12.ma"},
                {"release", "2027-01-12T18:00:00Z"}}}},
    {.code = "hold-list-without-end",
     .rank = Rank::caution,
     .text = "{list} holds station at waypoint {waypoint:label} without end, but the plan holds only for "
             "{wait_h:duration}",
     .hint = "Send {next} at the surfacing nearest to {release}",
     .slots = {{{"list", "goto_l11.ma"},
                {"waypoint", 4},
                {"wait_h", 30.5},
                {"next", "goto_l12.ma"},
                {"release", "2027-01-12T18:00:00Z"}}}},
    {.code = "hold-shorter-than-list",
     .rank = Rank::caution,
     .text = "the plan holds for {wait_h:duration} at waypoint {waypoint:label}, which is shorter than a "
             "list of two rows takes. The vehicle stays at the surface there",
     .hint = "Send the next list at {release}",
     .slots = {{{"wait_h", 0.5}, {"waypoint", 4}, {"release", "2027-01-12T18:00:00Z"}}}},
    {.code = "hold-not-in-lists",
     .rank = Rank::caution,
     .text = "the plan holds for {wait_h:duration} at waypoint {waypoint:label}, where the vehicle must not "
             "surface. No list ends there, so the vehicle flies on at once",
     .hint = "Plan again without holds (--max-hold 0), or depart later",
     .slots = {{{"wait_h", 1.5}, {"waypoint", 4}}}},
    {.code = "format-without-holds",
     .rank = Rank::caution,
     .text = "the plan holds for {wait_h:duration} at waypoint {waypoint:label}, but the format {format} "
             "cannot order a hold",
     .hint = "Keep the vehicle there until {release}",
     .slots = {{{"wait_h", 2.7}, {"waypoint", 4}, {"format", "gpx"}, {"release", "2027-01-12T18:00:00Z"}}}},
    {.code = "beyond-utm",
     .rank = Rank::caution,
     .text = "the plan goes beyond 84° N or 80° S. The vehicle navigates in UTM metres, which are not "
             "defined there",
     .hint = "Ask the vendor before the flight"},
    {.code = "thruster-not-in-files",
     .rank = Rank::caution,
     .text = "the legs to waypoints {waypoints} are planned with the thruster, but these files do not turn "
             "it on. Without the thruster the vehicle is slower and misses the planned times",
     .hint = "Set d_use_thruster and c_use_thruster in the yo of these legs, or plan with the thruster on "
             "all legs or on none",
     .slots = {{{"waypoints", "2 to 4"}}}},
    {.code = "currents-of-legs-not-told",
     .rank = Rank::caution,
     .text =
         "an older version stored the plan, without the currents on its legs. The goto lists may therefore "
         "allow too little for the drift, and the vehicle may come beside ice or below it",
     .hint = "Plan again before the flight"},

    // Below ice and icebergs.
    {.code = "files-pass-under-iceberg",
     .rank = Rank::caution,
     .text = "the plan passes under iceberg {iceberg} from {from} to {until}. During this time the "
             "vehicle must not surface",
     .hint = "Set the upper turn of the yo to {turn_m:.0f} m or deeper, and request no surfacing in this "
             "time",
     .slots = {{{"iceberg", "B-17"},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-12T19:00:00Z"},
                {"turn_m", 60.0}}}},
    {.code = "files-pass-below-ice",
     .rank = Rank::caution,
     .text = "the plan passes below ice or icebergs on the legs to these waypoints: {waypoints}",
     .hint = "Request no surfacing there, and set the upper turn of the yo to {turn_m:.0f} m or deeper",
     .slots = {{{"waypoints", "3 to 5"}, {"turn_m", 40.0}}}},
    {.code = "nowhere-to-surface",
     .rank = Rank::caution,
     .text = "on the legs to these waypoints the vehicle has no place to surface: {waypoints}",
     .hint = "Make sure that no setting on board makes it surface there",
     .slots = {{{"waypoints", "3 to 5"}}}},
    {.code = "upper-turns-not-told",
     .rank = Rank::caution,
     .text = "an older version stored the plan, without the upper turn of dives below ice",
     .hint = "Plan again before the flight"},
    {.code = "files-in-unknown-ice",
     .rank = Rank::caution,
     .text = "the ice on {unknown_km:distance} of the route is unknown. There the yo turns as in open water, "
             "or below the last known keels",
     .hint = "Make sure that the water there is open",
     .slots = {{{"unknown_km", 12.4}}}},
    {.code = "format-without-turns",
     .rank = Rank::caution,
     .text = "the plan passes below ice or icebergs, but the format {format} cannot tell the vehicle so. "
             "There the upper turn must be at {turn} or deeper, and the vehicle must not surface",
     .hint = "Set this in the vehicle's own files",
     .slots = {{{"format", "gpx"}, {"turn", "40 m"}}}},
    {.code = "stock-missions-needed",
     .rank = Rank::caution,
     .text = "under ice the vehicle responds to faults with breadcr.mi, freewig.mi and recov.mi. The export "
             "does not write these stock missions",
     .hint = "Make sure that they are on board, with dive depths for this water"},
    {.code = "safe-list-replaced",
     .rank = Rank::note,
     .text = "goto_l98.ma replaces the list of safe places on board. The firmware itself writes goto_l99.ma"},
    {.code = "no-ice-on-route",
     .rank = Rank::note,
     .text = "the route passes below no ice, so the mission surfaces at every waypoint and every "
             "{interval_h:duration}. The safe places and the settings for ice are for emergencies",
     .slots = {{{"interval_h", 3.0}}}},
    {.code = "safe-places-without-ice-data",
     .rank = Rank::caution,
     .text = "the plan was made without data on sea ice, so the mission surfaces at every waypoint and "
             "every {interval_h:duration}, as in open water",
     .hint = "If there may be ice on the route, ingest sea ice and plan again",
     .slots = {{{"interval_h", 3.0}}}},
    {.code = "watchdog-not-held-off",
     .rank = Rank::caution,
     .text = "a list takes {list_h:duration} below ice without contact, but the watchdog time "
             "no_cop_tickle_for of abend stays at 13.5 h",
     .hint = "Make sure that u_always_cop_tickle_hardware resets the watchdog in time",
     .slots = {{{"list_h", 20.0}}}},
    {.code = "surfacings-not-in-files",
     .rank = Rank::caution,
     .text = "{surfacings} planned {surfacings:surfacing is|surfacings are} not in the files, because below "
             "ice the vehicle surfaces only at the end of each list. The position error therefore grows "
             "until the end of the list",
     .slots = {{{"surfacings", 3}}}},
    {.code = "bed-unknown-below-ice",
     .rank = Rank::caution,
     .text = "the sea bed is unknown on part of the route",
     .hint = "Make sure that the yo has room there between the ice and the sea bed, and over every bank"},
    {.code = "iceberg-near-safe-place",
     .rank = Rank::caution,
     .text = "iceberg {iceberg} was seen within {away_km:distance} of the safe place {place}, and may drift "
             "there",
     .hint = "Make sure that the safe place stays clear",
     .slots = {{{"iceberg", "B-17"}, {"away_km", 3.0}, {"place", "-53.2000, 69.2000"}}}},
    {.code = "safe-place-unknown",
     .rank = Rank::caution,
     .text = "data on {unknown} at the safe place {place} are missing for part or all of the plan",
     .hint = "Make sure that the water there is open and deep enough",
     .slots = {{{"unknown", "the ice"}, {"place", "-53.2000, 69.2000"}}}},

    // The yo.
    {.code = "yo-above-plan",
     .rank = Rank::caution,
     .text =
         "the yo turns at {yo_m:.0f} m instead of the planned {planned_m:.0f} m. A glider dives deeper than "
         "this depth before it turns, and it aborts at its depth rating of {rating_m:.0f} m",
     .hint = "Check the energy and the times with this depth (--dive-depth {yo_m:.0f})",
     .slots = {{{"yo_m", 980.0}, {"planned_m", 1000.0}, {"rating_m", 1000.0}}}},
    {.code = "pump-of-profile",
     .rank = Rank::caution,
     .text = "pump and pitch in the yo file come from the vehicle profile, and the ballast is not checked",
     .hint = "Check all three before the flight"},
    {.code = "pump-and-thruster-of-profile",
     .rank = Rank::caution,
     .text = "pump, pitch and thruster in the yo file come from the vehicle profile, and the ballast is not "
             "checked",
     .hint = "Check all four before the flight"},
    {.code = "yo-cannot-fly-plan",
     .rank = Rank::caution,
     .text = "the waypoints {why}",
     .slots = {{{"why", "cannot be flown by the one yo of the mission"}}}},
    {.code = "yo-may-not-fly-plan",
     .rank = Rank::caution,
     .text = "the check does not show whether the plan can be flown {how}",
     .slots = {{{"how", "by the one yo of the mission"}}}},
    {.code = "yo-flies-otherwise",
     .rank = Rank::caution,
     .text = "with all legs flown {how}, {difference}",
     .hint = "For times and energy that hold, {instead}",
     .slots = {{{"how", "by the one yo of the mission"},
                {"difference", "the vehicle arrives 2.0 h later than planned"},
                {"instead", "plan anew for this yo"}}}},
    {.code = "yo-not-checked",
     .rank = Rank::caution,
     .text = "the yo turns at the same depths on the whole route. The stored data do not suffice to check "
             "that it can fly the plan",
     .hint = "Check the depths along the route yourself"},

    // Seagliders.
    {.code = "seaglider-limits-on-board",
     .rank = Rank::caution,
     .text = "the plan was made for the vehicle {vehicle}, and the cmdfile sets only $D_TGT and $T_DIVE",
     .hint =
         "Make sure that your Seaglider is as fast as the plan assumes and that its battery lasts. "
         "$T_MISSION "
         "and $D_ABORT on board must be larger, and the ballast and $MAX_BUOY must give the planned vertical "
         "speed",
     .slots = {{{"vehicle", "slocum-g3-1000"}}}},
    {.code = "seaglider-over-shoal",
     .rank = Rank::caution,
     .text = "$D_TGT is {dive_m:.0f} m, but the sea is only {bed_m:.0f} m deep at {place}, before waypoint "
             "{waypoint}. The plan dives only to {planned_m:.0f} m there",
     .hint = "Make sure that the vehicle's altimeter or its bathymetry map turns the dive in time, or plan "
             "again with a smaller dive depth",
     .slots = {{{"dive_m", 200.0},
                {"bed_m", 120.0},
                {"place", "-53.2000, 69.2000"},
                {"waypoint", 3},
                {"planned_m", 100.0}}}},
    {.code = "no-science-file",
     .rank = Rank::note,
     .text = "no science file is written, so the vehicle samples as it did before",
     .hint = "To change the sampling, give depth bands (--science)"},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message export_message(const Given&... given) {
  return make_message<export_kinds, code>(given...);
}

}  // namespace floeplan::messages
