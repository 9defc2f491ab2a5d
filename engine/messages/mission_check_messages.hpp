#pragma once

#include "engine/messages/kind.hpp"

/// What is found when mission files are judged together, in the stored data and beside a stored plan.
/// Ranks    danger: an error, the file is not to be flown; caution: a warning; note: good to know
/// Codes    those that scripts know, with underscores; a word behind a slash tells rows of one code apart
namespace floeplan::messages {

inline constexpr auto mission_check_kinds = std::to_array<Kind>({
    // Files together.
    {.code = "file_missing",
     .text = "asks for {file}, which is not among the files; the vehicle must have it",
     .slots = {{{"file", "yo10.ma"}}}},
    {.code = "nothing_dives",
     .rank = Rank::danger,
     .text = "a list but no yo: with nobody commanding pitch it aborts"},
    {.code = "nothing_steers", .text = "a yo but no list: nobody commands the heading"},
    {.code = "no_abend_to_fly", .rank = Rank::danger, .text = "without abend the vehicle aborts at once"},
    {.code = "target_below_overdepth",
     .rank = Rank::danger,
     .text = "the yo dives to {dive_m:.0f} m, at or below the overdepth of abend: the mission aborts on its "
             "first dive",
     .slots = {{{"dive_m", 200.0}}}},
    {.code = "waypoint_too_far",
     .rank = Rank::danger,
     .text = "leg {leg} is {leg_m:.0f} m long, beyond max_wpt_distance: the mission aborts",
     .slots = {{{"leg", 3}, {"leg_m", 140000.0}}}},
    {.code = "recovery_list",
     .rank = Rank::note,
     .text = "not part of the route: the firmware flies it to recover"},

    // The route in the data.
    {.code = "no_leg", .text = "one waypoint and no start: there is no leg to check"},
    {.code = "leg_too_long",
     .rank = Rank::danger,
     .text = "the leg is longer than 5000 km: are the coordinates right?"},
    {.code = "leg_closed",
     .rank = Rank::danger,
     .text = "{why} at {place} on {time}",
     .slots = {{{"why", "the route comes too close to an iceberg"},
                {"place", "-53.2000, 69.2000"},
                {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "leg_unknown",
     .text = "{why} at {place} on {time}",
     .slots = {{{"why", "the stored data do not cover this place at this time"},
                {"place", "-53.2000, 69.2000"},
                {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "bottom_above_target",
     .rank = Rank::danger,
     .text =
         "the yo turns at {dive_m:.0f} m without using the altimeter, but the sea bed lies at {bed_m:.0f} m",
     .slots = {{{"dive_m", 200.0}, {"bed_m", 120.0}}}},
    {.code = "bottom_above_climb",
     .rank = Rank::danger,
     .text = "the yo climbs to {climb_m:.0f} m and turns {altitude_m:.0f} m above the sea bed, yet that lies "
             "at {bed_m:.0f} m: there is no room for it",
     .slots = {{{"climb_m", 40.0}, {"altitude_m", 20.0}, {"bed_m", 60.0}}}},
    {.code = "sea_data",
     .text = "{ground}",
     .slots = {{{"ground", "The ice on 12.4 km of the route is unknown."}}}},
    {.code = "route_clear",
     .rank = Rank::note,
     .text = "clear; {route_km:.1f} km in {time_h:.1f} h, from {from} to {until}",
     .slots = {{{"route_km", 42.0},
                {"time_h", 33.5},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-14T03:30:00Z"}}}},

    // Below ice and icebergs.
    {.code = "ice_above_climb",
     .rank = Rank::danger,
     .text = "the yo climbs to {climb_m:.0f} m, but below the ice or icebergs of this leg it must turn no "
             "higher than {turn_m:.0f} m",
     .slots = {{{"climb_m", 3.0}, {"turn_m", 40.0}}}},
    {.code = "list_ends_below_ice",
     .rank = Rank::danger,
     .text = "the list ends here, and the vehicle surfaces below ice or icebergs"},
    {.code = "list_end_unknown",
     .text = "the list ends here, and the vehicle surfaces where the ice is unknown"},
    {.code = "list_ends_near_ice",
     .rank = Rank::danger,
     .text = "the list ends here, {room}",
     .slots = {{{"room", "300 m beyond the ice (waypoint radius 500 m, position error 1600 m)"}}}},
    {.code = "list_ends_near_ice/perhaps",
     .text = "the list ends here, {room}",
     .slots = {{{"room", "900 m beyond the ice (waypoint radius 500 m, position error 1600 m)"}}}},
    {.code = "surfaces_below_ice/dive",
     .rank = Rank::danger,
     .text = "surfaces after every dive, but ice or icebergs are above {legs}",
     .slots = {{{"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/waypoint",
     .rank = Rank::danger,
     .text = "{file} surfaces at this waypoint, {where}",
     .slots = {{{"file", "surfac10.ma"}, {"where", "below ice or icebergs"}}}},
    {.code = "surfaces_below_ice/interval",
     .rank = Rank::danger,
     .text = "surfaces every {interval_h:.1f} h, but ice or icebergs are above {legs}",
     .slots = {{{"interval_h", 4.0}, {"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/any-time",
     .text = "may surface at any time, but ice or icebergs are above {legs}",
     .slots = {{{"legs", "legs 2 to 4 of the route"}}}},
    {.code = "surfaces_below_ice/no-contact",
     .rank = Rank::danger,
     .text = "surfaces after {silence_h:.1f} h without contact, but is below ice or icebergs for up to "
             "{below_h:.1f} h after the last one, on {legs}",
     .slots = {{{"silence_h", 4.0}, {"below_h", 9.5}, {"legs", "legs 2 to 4 of the route"}}}},

    // Lists beside a stored plan.
    {.code = "as_planned", .rank = Rank::note, .text = "the lists order what the plan does"},
    {.code = "waypoint_left_out",
     .text = "{waypoints} of the plan left out",
     .slots = {{{"waypoints", "waypoints 3 to 5"}}}},
    {.code = "waypoint_not_in_plan", .text = "no waypoint of the plan lies here, or it is behind by now"},
    {.code = "hold_missing",
     .text = "the plan holds for {wait_h:.1f} h at waypoint {waypoint}, until {until}: no list holds there",
     .slots = {{{"wait_h", 2.7}, {"waypoint", 4}, {"until", "2027-01-12T18:00:00Z"}}}},
    {.code = "hold_not_in_plan",
     .text = "holds station after waypoint {waypoint}, where the plan does not hold",
     .slots = {{{"waypoint", 4}}}},
    {.code = "hold_beyond_circle",
     .text = "its rows lie up to {farthest_m:.0f} m from waypoint {waypoint}; the plan found a circle of "
             "{circle_m:.0f} m clear",
     .slots = {{{"farthest_m", 900.0}, {"waypoint", 4}, {"circle_m", 500.0}}}},
    {.code = "hold_of_other_time",
     .text = "its comment says that the hold ends at {ends}; the plan holds until {until}",
     .slots = {{{"ends", "2027-01-12T18:00:00Z"}, {"until", "2027-01-12T20:00:00Z"}}}},
    {.code = "hold_of_other_length",
     .text = "its {legs} legs take {takes}; the plan holds for {wait_h:.1f} h",
     .slots = {{{"legs", 5}, {"takes", "about 1.2 h"}, {"wait_h", 2.7}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message mission_check_message(const Given&... given) {
  return make_message<mission_check_kinds, code>(given...);
}

}  // namespace floeplan::messages
