#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about a plan, isochrones and simulated flights.
/// Ranks    Danger: flown as it is, the plan may cost the vehicle, which surfaces below ice or meets an
///          iceberg that the plan does not avoid; repeated at every export. Caution: an assumption of the
///          plan may be wrong, or a request is not kept; the vehicle may be late, short of energy or off its
///          route, and the pilot can see to it. Note: the plan is valid; how it was made, or that a better
///          one may exist
namespace floeplan::messages {

inline constexpr auto plan_kinds = std::to_array<Kind>({
    // Ice above the vehicle.
    {.code = "start-under-ice",
     .rank = Rank::danger,
     .text = "the start lies under ice, so the vehicle must not surface there. The plan is valid only if the "
             "vehicle is launched below the ice",
     .hint = "Move the start to open water. The simulator refuses a plan that begins under ice"},
    {.code = "start-ice-unknown",
     .rank = Rank::caution,
     .text = "the ice at the start is unknown, so the plan includes no surfacing there",
     .hint = "Make sure that the water there is open"},
    {.code = "goal-under-ice",
     .rank = Rank::danger,
     .text = "the goal lies under ice, so the vehicle must not surface there",
     .hint = "Move the goal to open water"},
    {.code = "goal-ice-unknown",
     .rank = Rank::caution,
     .text = "the ice at the goal is unknown, so the plan includes no surfacing there",
     .hint = "Make sure that the water there is open, or move the goal"},
    {.code = "vias-under-ice",
     .rank = Rank::danger,
     .text = "{under} of {vias} {vias:via point|via points} {under:lies|lie} under ice (number {numbers}), "
             "so the vehicle must not surface there",
     .hint = "Move {under:this via point|these via points} to open water, or make sure that the vehicle need "
             "not surface there",
     .slots = {{{"under", 1}, {"vias", 3}, {"numbers", "2"}}}},
    {.code = "long-below-ice",
     .rank = Rank::danger,
     .text = "the vehicle is below ice for {longest_h:duration} without a place to surface. During this "
             "time it has no fix and no contact, and it cannot surface in an emergency",
     .hint = "Limit this time (--max-time-without-surfacing), or lead the route away from the ice (--via)",
     .slots = {{{"longest_h", 17.5}}}},
    {.code = "ice-unknown-on-route",
     .rank = Rank::caution,
     .text = "the ice on {unknown_km:distance} of the route is unknown. The vehicle passes there, but the "
             "plan includes no surfacing there",
     .hint = "Ingest ice data that cover the route",
     .slots = {{{"unknown_km", 12.4}}}},
    // Cautions, not dangers: the planned route itself is clear; only a position error brings the vehicle to
    // the ice.
    {.code = "ice-beside",
     .rank = Rank::caution,
     .text = "the position error at {lon_deg:.4f}, {lat_deg:.4f} is {error_km:distance}, so the vehicle may "
             "come below the ice beside the route. Below that ice the upper turn must be at {turn_m:.0f} m "
             "or deeper, but it is planned at {planned_turn_m:.0f} m",
     .hint = "Set a deeper upper turn for the whole route (--climb-to {turn_m:.0f}), or limit the time "
             "without surfacing (--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 40.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "ice-beside-needs-deeper-dives",
     .rank = Rank::caution,
     .text = "the position error at {lon_deg:.4f}, {lat_deg:.4f} is {error_km:distance}, so the vehicle may "
             "come below the ice beside the route. Below that ice the upper turn must be at {turn_m:.0f} m "
             "or deeper, but it is planned at {planned_turn_m:.0f} m",
     .hint = "Set deeper dives for the whole route (--climb-to {turn_m:.0f} --dive-depth {dive_m:.0f}), or "
             "limit the time without surfacing (--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0},
                {"dive_m", 220.0}}}},
    {.code = "ice-beside-too-deep",
     .rank = Rank::caution,
     .text = "the position error at {lon_deg:.4f}, {lat_deg:.4f} is {error_km:distance}, so the vehicle may "
             "come below the ice beside the route. Below that ice the upper turn must be at {turn_m:.0f} m "
             "or deeper, but it is planned at {planned_turn_m:.0f} m",
     .hint = "This vehicle cannot dive below that ice. Choose a vehicle that dives deeper, or limit the time "
             "without surfacing (--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "surfacings-near-ice",
     .rank = Rank::caution,
     .text =
         "at {near} of {surfacings} planned surfacings the position error exceeds the distance to the ice. "
         "At the first, {first}, the ice is {ice_km:distance} away and the position error is "
         "{error_km:distance}",
     .hint = "Surface more often (--surfacing-interval), or lead the route away from the ice (--via)",
     .slots = {{{"near", 2},
                {"surfacings", 4},
                {"first", "2027-01-12T18:00:00Z"},
                {"ice_km", 1.2},
                {"error_km", 2.3}}}},
    {.code = "longer-below-ice-without-leads",
     .rank = Rank::danger,
     .text = "the plan counts on leads that are narrower than the position error, so the vehicle could "
             "miss them. With these leads it is at most {longest_h:duration} without a place to surface, "
             "without them {sure_h:duration}. During this time it has no fix and no contact, and it "
             "cannot surface in an emergency",
     .hint = "Limit this time (--max-time-without-surfacing), or lead the route away from the ice "
             "(--via)",
     .slots = {{{"sure_h", 71.0}, {"longest_h", 17.0}}}},
    // A danger: beyond the pilot's own limit, and an error as large as expected is enough.
    {.code = "leads-may-be-missed",
     .rank = Rank::danger,
     .text = "the route keeps the limit of {bound_h:duration} without a place to surface only if the "
             "vehicle finds leads that are narrower than its position error. Without these leads, the "
             "longest time is {sure_h:duration}",
     .hint =
         "Set a shorter limit (--max-time-without-surfacing), or lead the route away from the ice (--via)",
     .slots = {{{"bound_h", 12.0}, {"sure_h", 19.5}}}},
    {.code = "escapes-end-near-ice",
     .rank = Rank::caution,
     .text = "{near} {near:escape route ends|escape routes end} closer to ice than the position error. The "
             "first, from waypoint {waypoint:label}, ends {ice_km:distance} from the ice with a position "
             "error of {error_km:distance}",
     .hint = "In an emergency, let the vehicle fly on into open water before it surfaces",
     .slots = {{{"near", 6}, {"waypoint", 3}, {"ice_km", 1.2}, {"error_km", 2.3}}}},
    {.code = "surfaces-more-often",
     .rank = Rank::note,
     .text = "the fastest route has waypoints without an escape route. This route takes longer, but it "
             "passes more places to surface and has an escape route from every waypoint"},

    // The sea bed.
    {.code = "low-water-at-bed",
     .rank = Rank::caution,
     .text = "at {time} the water falls to {fall_m:.1f} m below its datum ({datum}), as the water levels "
             "\"{levels}\" say. "
             "If the bathymetry counts from this datum, the dives of this plan reach {below_m:.1f} m below "
             "the sea bed",
     .hint = "Keep the vehicle further from the bed (--altimeter-margin {margin_m:.0f})",
     .slots = {{{"time", "2027-01-12T18:00:00Z"},
                {"fall_m", 12.4},
                {"datum", "mean sea level"},
                {"levels", "bay levels"},
                {"below_m", 2.4},
                {"margin_m", 13.0}}}},

    // Icebergs.
    {.code = "sightings-too-old-at-departure",
     .rank = Rank::danger,
     .text =
         "{ignored} {ignored:iceberg was|icebergs were} ignored ({names}). At the departure, {departure}, "
         "{ignored:its last sighting is|their last sightings are} too old. {ignored:The iceberg|Each} may "
         "still be near the route, and the plan {ignored:does not avoid it|avoids none of them}",
     .hint = "Depart earlier, ingest newer sightings, or raise the maximum sighting age (--max-sighting-age)",
     .slots = {{{"ignored", 2}, {"departure", "2027-01-12T06:00:00Z"}, {"names", "B-17, B-18"}}}},
    // No request may ask for sightings as old as these.
    {.code = "sightings-too-old-for-any-plan-then",
     .rank = Rank::danger,
     .text =
         "{ignored} {ignored:iceberg was|icebergs were} ignored ({names}). At the departure, {departure}, "
         "{ignored:its last sighting is|their last sightings are} too old. {ignored:The iceberg|Each} may "
         "still be near the route, and the plan {ignored:does not avoid it|avoids none of them}",
     .hint = "Depart earlier, or ingest newer sightings",
     .slots = {{{"ignored", 2}, {"departure", "2027-01-12T06:00:00Z"}, {"names", "B-17, B-18"}}}},
    {.code = "drift-unknown-near-route",
     .rank = Rank::caution,
     .text = "{near} of {icebergs} {icebergs:iceberg|icebergs} may come near the route ({names}), but "
             "the currents are unknown for part of {near:its|their} drift. For that part the plan "
             "assumes that each iceberg keeps its last observed drift. An iceberg without such a drift "
             "is assumed to drift with the wind, or to stay in place if the wind is unknown",
     .hint = "Ingest newer sightings, or currents that begin earlier and cover a wider area",
     .slots = {{{"near", 3}, {"icebergs", 60}, {"names", "B-17, B-18, B-19"}}}},
    {.code = "drift-unknown-elsewhere",
     .rank = Rank::note,
     .text = "the currents are unknown for part of the drift of {elsewhere} of {icebergs} "
             "{icebergs:iceberg|icebergs}. {elsewhere:This iceberg is|These icebergs are} too far away to "
             "come near the route",
     .slots = {{{"elsewhere", 57}, {"icebergs", 60}}}},
    // Requested, and safe if flown as planned. The pilot must know which yo to send.
    {.code = "passes-under-iceberg",
     .rank = Rank::caution,
     .text = "the plan passes under iceberg {iceberg} from {from} to {until}. During this time the "
             "vehicle must not surface, and the upper turn must be at {turn_m:.0f} m or deeper",
     .hint = "Set the upper turn of the vehicle to this depth for this time",
     .slots = {{{"iceberg", "B-17"},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-12T19:00:00Z"},
                {"turn_m", 60.0}}}},
    {.code = "currents-of-shallower-turns",
     .rank = Rank::caution,
     .text = "below icebergs the vehicle turns at up to {turn_m:.0f} m. The plan counts the energy of "
             "these deeper dives, but its times are those of dives with an upper turn at "
             "{planned_turn_m:.0f} m. The vehicle may arrive earlier or later than planned",
     .hint = "To see the difference, plan with the deeper upper turn (--climb-to {turn_m:.0f})",
     .slots = {{{"turn_m", 60.0}, {"planned_turn_m", 10.0}}}},

    // Currents.
    {.code = "currents-of-nearest-water",
     .rank = Rank::caution,
     .text = "on {share_pct:.0f} % of the route the current model has land, because its coast is coarser "
             "than the true coast. There the plan uses the current of the nearest water in the model, "
             "and the true current may differ",
     .hint = "Ingest a current model with finer steps, or lead the route farther from the coast (--via)",
     .slots = {{{"share_pct", 4.0}}}},
    {.code = "dives-below-currents",
     .rank = Rank::caution,
     .text = "on {unknown_km:distance} of the route the dives go deeper than the current model. At worst "
             "they go to {dive_m:.0f} m, where the currents end at {known_m:.0f} m. Below the model the "
             "plan uses the mean of the currents above, and the true current may differ",
     .hint = "Ingest currents that reach deeper, or dive less deep (--dive-depth)",
     .slots = {{{"unknown_km", 12.4}, {"dive_m", 200.0}, {"known_m", 60.0}}}},
    {.code = "passes-close-to-land",
     .rank = Rank::caution,
     .text = "at {lon_deg:.4f}, {lat_deg:.4f} the route passes only {distance_m:distance} from land, closer "
             "than the position error of {error_m:distance} there",
     .hint = "Lead the route farther from land (--via)",
     .slots = {{{"lon_deg", -60.25}, {"lat_deg", 69.5}, {"distance_m", 74.0}, {"error_m", 156.0}}}},
    {.code = "hardly-enough-speed",
     .rank = Rank::caution,
     .text = "on {legs} {legs:leg|legs} the vehicle needs more than {enough_pct:.0f} % of its speed to hold "
             "the course against the current. Leg {leg} at {time} needs the most, {most_pct:.1f} %. A "
             "slightly slower vehicle would drift off the route there",
     .hint = "Lead the route through weaker current (--via), or depart at another time. Plan with a "
             "slightly lower speed (--speed) to see whether a route with more reserve exists",
     .slots = {{{"legs", 1},
                {"enough_pct", 95.0},
                {"leg", 3},
                {"time", "2027-01-12T18:00:00Z"},
                {"most_pct", 98.2}}}},
    {.code = "several-grids-tried",
     .rank = Rank::caution,
     .text = "some currents in the area are as fast as the vehicle, so a small change of the search grid "
             "can open or close a route. Several grids were tried, and this plan is the best of their "
             "plans",
     .hint = "A smaller grid spacing (--spacing) or a via point (--via) may give a better plan"},
    {.code = "several-grids-agree",
     .rank = Rank::note,
     .text = "some currents in the area are as fast as the vehicle, so several grids were tried. Their "
             "plans differ by less than {agreement_pct:.0f} %, and this plan is the best of them",
     .slots = {{{"agreement_pct", 1.0}}}},
    {.code = "alternative",
     .rank = Rank::note,
     .text = "this route passes {side} of the {obstacle} at {lon_deg:.4f}, {lat_deg:.4f} "
             "({extent_km:distance} "
             "across). The best route passes on the other side. This route takes {more}",
     .slots = {{{"side", "south"},
                {"obstacle", "land"},
                {"lon_deg", -53.5},
                {"lat_deg", 69.25},
                {"extent_km", 12.0},
                {"more", "3 h 12 min more"}}}},
    {.code = "nothing-to-go-round",
     .rank = Rank::note,
     .text = "there is no alternative. Near the route lies no obstacle of {least_km:distance} or more that "
             "the vehicle could pass on its other side",
     .slots = {{{"least_km", 4.2}}}},
    {.code = "few-alternatives",
     .rank = Rank::note,
     .text = "fewer alternatives were found than requested. {tried} {tried:route|routes} on other sides of "
             "obstacles {tried:was|were} tried. The rejected routes are closed, take more than "
             "{longest_h:duration}, or hardly differ from the others",
     .slots = {{{"tried", 4}, {"longest_h", 91.0}}}},
    {.code = "may-depart-later",
     .rank = Rank::note,
     .text = "the vehicle may depart {later_h:duration} later, at {time}, and still arrive at the same time",
     .slots = {{{"later_h", 2.9}, {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "route-without-holds",
     .rank = Rank::caution,
     .text = "part of the water is closed at first and reopens later. The vehicle is not allowed to hold "
             "until then, but a route with a hold may arrive earlier",
     .hint = "Allow holds (--max-hold)"},

    // Uncertain currents.
    {.code = "closed-in-members",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members of the ensemble of currents, the vehicle does not reach "
             "the goal on this route. No other route that was compared reaches the goal in more members",
     .hint = "Depart at another time, or raise the speed (--speed)",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "closed-members-left-out-of-mean",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members of the ensemble of currents, the vehicle does not reach "
             "the goal on this route. No other route that was compared reaches the goal in more members. "
             "The mean counts only the other members",
     .hint = "Depart at another time, or raise the speed (--speed)",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "share-of-members-not-met",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members of the ensemble of currents, the vehicle does not reach "
             "the goal on this route. No other route that was compared reaches the goal in more members. "
             "The request asks for arrival in {share_pct:.0f} % of the members. This plan has the best "
             "mean among the members that arrive",
     .hint = "Depart at another time, or raise the speed (--speed)",
     .slots = {{{"closed", 2}, {"members", 12}, {"share_pct", 90.0}}}},
    {.code = "named-members-not-used",
     .rank = Rank::caution,
     .text = "the plan uses random members around the first of the named currents. The other named currents "
             "were not used",
     .hint = "To plan over the named currents, leave out the number of members (--members)"},
    {.code = "uncertainty-without-members",
     .rank = Rank::caution,
     .text = "the requested uncertainty has no effect, because the request has only one set of currents and "
             "no model of their errors",
     .hint = "Name several currents (--currents), or give the number of members (--members) and their error "
             "(--current-error)"},
    {.code = "late-in-first-currents",
     .rank = Rank::caution,
     .text = "in the first of the currents, the plan arrives at {arrival}, after the wanted arrival. The "
             "{what_counts} of all members, {counted}, is in time",
     .hint = "To be in time in the first currents, too, depart earlier or raise the speed (--speed)",
     .slots = {{{"arrival", "2027-01-13T18:10:00Z"},
                {"what_counts", "mean"},
                {"counted", "2027-01-13T17:50:00Z"}}}},

    // Times and areas.
    {.code = "early-arrival",
     .rank = Rank::note,
     .text = "the plan arrives {early_h:duration} before the wanted arrival. No later departure was found "
             "that arrives in time",
     .slots = {{{"early_h", 3.5}}}},
    {.code = "departures-not-all-planned",
     .rank = Rank::note,
     .text = "{planned} of {departures} departures were planned in full, and this plan is the best of them. "
             "Another departure may be better over all members of the ensemble of currents",
     .hint = "In a shorter window, all departures are planned in full",
     .slots = {{{"departures", 48}, {"planned", 6}}}},
    {.code = "area-opens-just-before",
     .rank = Rank::caution,
     .text = "after {under_way_h:duration} under way, the vehicle is at {lon_deg:.4f}, {lat_deg:.4f} only "
             "{spare_min:.0f} min after an area there reopens ({changes}). A vehicle {error_pct:.0f} % "
             "faster than planned would break the rule of the area",
     .hint = "Depart later, or lead the route round the area",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"spare_min", 12.0},
                {"changes", "2027-01-12T18:00:00Z"},
                {"under_way_h", 12.2},
                {"error_pct", 5.0}}}},
    {.code = "area-closes-just-after",
     .rank = Rank::caution,
     .text = "after {under_way_h:duration} under way, the vehicle is at {lon_deg:.4f}, {lat_deg:.4f} only "
             "{spare_min:.0f} min before an area there closes ({changes}). A vehicle {error_pct:.0f} % "
             "slower than planned would break the rule of the area",
     .hint = "Depart earlier, or lead the route round the area",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"spare_min", 12.0},
                {"changes", "2027-01-12T18:00:00Z"},
                {"under_way_h", 12.2},
                {"error_pct", 5.0}}}},

    // The battery. Cautions, not dangers, because the reserve for a recovery is not counted.
    {.code = "battery-too-small",
     .rank = Rank::caution,
     .text = "the plan needs {drawn_mj:.2f} MJ, but the battery has only {usable_mj:.2f} MJ above its "
             "reserve. {missing_mj:.2f} MJ are missing",
     .hint = "Start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter route",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.25}, {"usable_mj", 1.0}}}},
    {.code = "battery-below-reserve",
     .rank = Rank::caution,
     .text = "the plan needs {drawn_mj:.2f} MJ, but at the departure the battery is already {missing_mj:.2f} "
             "MJ below its reserve",
     .hint = "Start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter route",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.1}}}},
    {.code = "battery-too-small-for-escape",
     .rank = Rank::caution,
     .text = "the escape route from waypoint {waypoint:label} needs {drawn_mj:.2f} MJ, but at that waypoint "
             "the battery has only {left_mj:.2f} MJ above its reserve",
     .hint = "Start with a fuller battery, plan a route nearer to open water, or plan without escape routes "
             "(leave out --escape-plan)",
     .slots = {{{"waypoint", 3}, {"drawn_mj", 0.4}, {"left_mj", 0.25}}}},

    // The search for the route.
    {.code = "search-cut-short",
     .rank = Rank::note,
     .text = "the search stopped at its limit of computing work. The plan is valid, but a better route "
             "may exist",
     .hint = "Choose a larger grid spacing (--spacing), so that the search can finish"},
    {.code = "search-cut-short-near-the-best",
     .rank = Rank::note,
     .text = "the search stopped at its limit of computing work. The plan is valid, but on the same "
             "grid a route may exist that is faster by up to {gain_min:.0f} min ({gain_pct:.1f} %)",
     .hint = "Choose a larger grid spacing (--spacing), so that the search can finish",
     .slots = {{{"gain_min", 4.0}, {"gain_pct", 0.3}}}},
    {.code = "cost-search-cut-short",
     .rank = Rank::note,
     .text = "the search stopped at its limit of computing work. The plan is valid, but a plan of "
             "lower cost may exist",
     .hint = "Choose a larger grid spacing (--spacing), so that the search can finish"},
    {.code = "route-not-refined",
     .rank = Rank::note,
     .text = "the route keeps to the lines of the search grid. A route off these lines would be faster, but "
             "it would break a limit of the request, such as the longest time without a place to surface",
     .hint = "A smaller grid spacing (--spacing) may give a faster route"},
    {.code = "more-waypoints-than-asked",
     .rank = Rank::caution,
     .text = "the route needs more waypoints than requested. With fewer waypoints it would be closed or have "
             "legs that are too long",
     .hint = "Allow more waypoints (--max-waypoints)"},

    // Isochrones: an area that is too small endangers no plan, so most of these are notes.
    {.code = "areas-in-strong-currents",
     .rank = Rank::note,
     .text = "some currents in the area are as fast as the vehicle, so the search cannot use some legs "
             "of its grid. The isochrones may therefore be a few per cent too small",
     .hint = "Another grid spacing (--spacing) may show larger isochrones"},
    {.code = "areas-to-a-place-in-strong-currents",
     .rank = Rank::note,
     .text = "some currents in the area are as fast as the vehicle, so the search cannot use some legs "
             "of its grid. The isochrones may therefore be a few per cent too small. They may also "
             "leave out places from which the vehicle arrives in time only after a closed route reopens",
     .hint = "Another grid spacing (--spacing) may show larger isochrones"},
    {.code = "areas-beyond-battery",
     .rank = Rank::caution,
     .text = "the battery has {usable_mj:.2f} MJ above its reserve, which last at most {lasts_h:duration}. "
             "The vehicle cannot reach the isochrones of longer times",
     .hint = "Start with a fuller battery, or ask only for shorter times",
     .slots = {{{"usable_mj", 1.0}, {"lasts_h", 96.0}}}},
    {.code = "areas-cut-short",
     .rank = Rank::note,
     .text = "the search stopped at its limit of computing work, so the true isochrones may be larger",
     .hint = "Choose a larger grid spacing (--spacing), so that the search can finish"},
    {.code = "areas-cut-at-the-data",
     .rank = Rank::note,
     .text = "the isochrone ends at the edge of the data, but currents carry the vehicle farther",
     .hint = "Ingest data that cover a wider area"},

    // Texts from a request or file, or from a plan stored before messages had codes.
    {.code = "remark",
     .rank = Rank::note,
     .text = "{remark}",
     .slots = {{{"remark", "the route was read from track.gpx"}}}},
    {.code = "mission-file-note",
     .rank = Rank::note,
     .text = "{remark}",
     .slots = {{{"remark",
                 "A goto list ends below ice, where the vehicle cannot surface, so the simulation flies the "
                 "next list at once."}}}},
    {.code = "speed-not-made",
     .rank = Rank::caution,
     .text = "with this pump and pitch, no plausible drag gives the planned speed. The flight uses the drag "
             "of the vehicle profile, so the vehicle is slower or faster than planned",
     .hint = "Check the pump, the pitch and the planned speed"},
    {.code = "earlier-danger",
     .rank = Rank::danger,
     .text = "{remark}",
     .slots = {{{"remark", "the goal lies under ice, so the vehicle must not surface there"}}}},
    {.code = "earlier-warning",
     .rank = Rank::caution,
     .text = "{remark}",
     .slots = {{{"remark", "no sea ice was stored for this area, so open water is assumed"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message plan_message(const Given&... given) {
  return make_message<plan_kinds, code>(given...);
}

}  // namespace floeplan::messages
