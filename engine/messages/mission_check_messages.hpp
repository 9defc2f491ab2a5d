#pragma once

#include "engine/messages/kind.hpp"

/// Findings when mission files are checked together, with the stored data and against a stored plan.
/// Ranks    danger: an error, the file must not be flown; caution: a warning; note: good to know
/// Codes    with underscores, known to scripts; a word after a slash distinguishes rows with the same code
namespace floeplan::messages {

inline constexpr auto mission_check_kinds = std::to_array<Kind>({
    // Several files together.
    {.code = "file_missing",
     .text = "the mission asks for {file}, which was not given",
     .hint = "make sure that the vehicle has it",
     .slots = {{{"file", "yo10.ma"}}}},
    {.code = "nothing_dives",
     .rank = Rank::danger,
     .text = "the files hold a goto list but no yo. Nothing commands the pitch, so the vehicle aborts",
     .hint = "add a yo"},
    {.code = "nothing_steers",
     .text = "the files hold a yo but no goto list, so nothing commands the heading",
     .hint = "add a goto list"},
    {.code = "no_abend_to_fly",
     .rank = Rank::danger,
     .text = "the mission has no abend, so the vehicle aborts at once",
     .hint = "add the behavior abend"},
    {.code = "target_below_overdepth",
     .rank = Rank::danger,
     .text = "the yo dives to {dive_m:.0f} m, at or below the overdepth of abend, so the vehicle aborts on "
             "its first dive",
     .hint = "dive less deep, or set a deeper overdepth",
     .slots = {{{"dive_m", 200.0}}}},
    {.code = "waypoint_too_far",
     .rank = Rank::danger,
     .text = "leg {leg} is {leg_m:distance} long, longer than max_wpt_distance, so the vehicle aborts",
     .hint = "divide the leg, or raise max_wpt_distance",
     .slots = {{{"leg", 3}, {"leg_m", 140000.0}}}},
    {.code = "recovery_list",
     .rank = Rank::note,
     .text = "this list is not part of the route. The firmware flies it to recover the vehicle"},

    // The route in the data.
    {.code = "no_leg",
     .text = "the list has one waypoint and no start is given, so no leg can be checked",
     .hint = "give the start"},
    {.code = "leg_too_long",
     .rank = Rank::danger,
     .text = "the leg is longer than 5000 km",
     .hint = "check the coordinates"},
    {.code = "leg_closed",
     .rank = Rank::danger,
     .text = "at {place} on {time}, {why}",
     .slots = {{{"why", "the route comes too close to an iceberg"},
                {"place", "-53.2000, 69.2000"},
                {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "leg_unknown",
     .text = "at {place} on {time}, {why}",
     .slots = {{{"why", "the stored data do not cover this place at this time"},
                {"place", "-53.2000, 69.2000"},
                {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "bottom_above_target",
     .rank = Rank::danger,
     .text =
         "the yo dives to {dive_m:.0f} m without using the altimeter, but the sea bed lies at {bed_m:.0f} m",
     .hint = "dive less deep, or use the altimeter",
     .slots = {{{"dive_m", 200.0}, {"bed_m", 120.0}}}},
    {.code = "bottom_above_climb",
     .rank = Rank::danger,
     .text = "the yo climbs to {climb_m:.0f} m and turns {altitude_m:.0f} m above the sea bed, but the sea "
             "bed lies at {bed_m:.0f} m, so the yo has no room",
     .hint = "plan a route over deeper water, or turn nearer to the surface or to the sea bed",
     .slots = {{{"climb_m", 40.0}, {"altitude_m", 20.0}, {"bed_m", 60.0}}}},
    {.code = "sea_data",
     .text = "{ground}",
     .slots = {{{"ground", "The ice on 12.4 km of the route is unknown."}}}},
    {.code = "route_clear",
     .rank = Rank::note,
     .text = "the route is clear: {route_km:distance} in {time_h:duration}, from {from} to {until}",
     .slots = {{{"route_km", 42.0},
                {"time_h", 33.5},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-14T03:30:00Z"}}}},

    // Below ice and icebergs.
    {.code = "ice_above_climb",
     .rank = Rank::danger,
     .text = "the yo climbs to {climb_m:.0f} m, but below the ice or icebergs of this leg its upper turn "
             "must be at {turn_m:.0f} m or deeper",
     .hint = "set a deeper upper turn",
     .slots = {{{"climb_m", 3.0}, {"turn_m", 40.0}}}},
    {.code = "list_ends_below_ice",
     .rank = Rank::danger,
     .text = "the list ends here, so the vehicle surfaces below ice or icebergs",
     .hint = "end the list in open water"},
    {.code = "list_end_unknown",
     .text = "the list ends here, so the vehicle surfaces where the ice is unknown",
     .hint = "make sure that the water is open"},
    {.code = "list_ends_near_ice",
     .rank = Rank::danger,
     .text = "the list ends here and the vehicle surfaces, only {room}",
     .hint = "end the list farther from the ice",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1.6 km)"}}}},
    {.code = "list_ends_near_ice/perhaps",
     .text = "the list ends here and the vehicle surfaces, only {room}",
     .hint = "make sure that the water is open",
     .slots = {{{"room", "900 m beyond the ice (waypoint radius 500 m, position error 1.6 km)"}}}},
    {.code = "surfaces_below_ice/dive",
     .rank = Rank::danger,
     .text = "the vehicle surfaces after every dive, but ice or icebergs lie above {legs}",
     .hint = "send another vehicle, or plan a route in open water",
     .slots = {{{"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/waypoint",
     .rank = Rank::danger,
     .text = "{file} orders a surfacing at this waypoint, {where}",
     .hint = "take this surfacing out, or plan a route in open water",
     .slots = {{{"file", "surfac10.ma"}, {"where", "below ice or icebergs"}}}},
    {.code = "surfaces_below_ice/interval",
     .rank = Rank::danger,
     .text = "the vehicle surfaces every {interval_h:duration}, but ice or icebergs lie above {legs}",
     .hint = "take this surfacing out, or plan a route in open water",
     .slots = {{{"interval_h", 4.0}, {"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/any-time",
     .text = "the vehicle may surface at any time, but ice or icebergs lie above {legs}",
     .hint = "make sure that the vehicle does not surface on these legs",
     .slots = {{{"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/no-contact",
     .rank = Rank::danger,
     .text = "the vehicle surfaces after {silence_h:duration} without contact, but it is below ice or "
             "icebergs for up to {below_h:duration} after its last contact, on {legs}",
     .hint = "allow a longer time without contact, or plan a route in open water",
     .slots = {{{"silence_h", 4.0}, {"below_h", 9.5}, {"legs", "legs 2 to 4 of the route"}}}},

    // Lists beside a stored plan.
    {.code = "as_planned", .rank = Rank::note, .text = "the lists order the same route as the plan"},
    {.code = "waypoint_left_out",
     .text = "the lists leave out {waypoints} of the plan",
     .hint = "export the plan again if the vehicle is to pass them",
     .slots = {{{"waypoints", "waypoints 3 to 5"}}}},
    {.code = "waypoint_not_in_plan",
     .text = "this row is not a waypoint of the plan, or the plan has passed it already",
     .hint = "export the plan again, or check this row"},
    {.code = "hold_missing",
     .text =
         "the plan holds for {wait_h:duration} at waypoint {waypoint:label}, until {until}, but no list "
         "holds there",
     .hint = "export the plan again",
     .slots = {{{"wait_h", 2.7}, {"waypoint", 4}, {"until", "2027-01-12T18:00:00Z"}}}},
    {.code = "hold_not_in_plan",
     .text = "the list holds station after waypoint {waypoint:label}, where the plan does not hold",
     .hint = "export the plan again",
     .slots = {{{"waypoint", 4}}}},
    {.code = "hold_beyond_circle",
     .text = "the rows of the list lie up to {farthest_m:distance} from waypoint {waypoint:label}, but the "
             "plan checked only a circle of {circle_m:distance}",
     .hint = "move the rows closer to the waypoint",
     .slots = {{{"farthest_m", 900.0}, {"waypoint", 4}, {"circle_m", 500.0}}}},
    {.code = "hold_of_other_time",
     .text = "the comment of the list says that the hold ends at {ends}, but the plan holds until "
             "{until}",
     .hint = "export the plan again",
     .slots = {{{"ends", "2027-01-12T18:00:00Z"}, {"until", "2027-01-12T20:00:00Z"}}}},
    {.code = "hold_of_other_length",
     .text = "the {legs} legs of the list take {takes}, but the plan holds for {wait_h:duration}",
     .hint = "export the plan again",
     .slots = {{{"legs", 5}, {"takes", "about 1 h 12 min"}, {"wait_h", 2.7}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message mission_check_message(const Given&... given) {
  return make_message<mission_check_kinds, code>(given...);
}

}  // namespace floeplan::messages
