#pragma once

#include "engine/messages/kind.hpp"

/// What a pilot is told of a plan, of isochrones and of simulated flights.
/// Ranks    danger: followed as it is, the plan may cost the vehicle, which comes up below ice or meets an iceberg that
///          nobody avoids; told again at every export. Caution: something the plan rests on may be otherwise, or what
///          was asked for is not kept; the vehicle may be late, short of energy or off its way, and the pilot can see to
///          it. Note: the plan holds; how it was made, and that a better one may exist
namespace floeplan::messages {

inline constexpr auto plan_kinds = std::to_array<Kind>({
    // Ice above the vehicle.
    {.code = "start-under-ice",
     .rank = Rank::danger,
     .text = "the start lies under ice: the vehicle may not surface there. The plan holds only if the "
             "vehicle is brought below the ice",
     .hint = "Move the start to open water. The simulator flies no plan that begins under ice"},
    {.code = "start-ice-unknown",
     .rank = Rank::caution,
     .text = "the ice at the start is unknown: the plan counts on no surfacing there",
     .hint = "Make sure that the water is open"},
    {.code = "goal-under-ice",
     .rank = Rank::danger,
     .text = "the goal lies under ice: the vehicle may not surface there",
     .hint = "Move the goal to open water"},
    {.code = "goal-ice-unknown",
     .rank = Rank::caution,
     .text = "the ice at the goal is unknown: the plan counts on no surfacing there"},
    {.code = "vias-under-ice",
     .rank = Rank::danger,
     .text = "{under} of {vias} {vias:via point lies|via points lie} under ice (number {numbers}): the "
             "vehicle may not surface there",
     .hint = "Move them to open water, or make sure that the vehicle need not surface there",
     .slots = {{{"under", 1}, {"vias", 3}, {"numbers", "2"}}}},
    {.code = "long-below-ice",
     .rank = Rank::danger,
     .text = "the vehicle is below ice for {longest_h:.1f} h without a place to surface: no fix, no contact, "
             "no ascent in an emergency",
     .hint = "Limit that time (--max-time-without-surfacing), or keep away from the ice",
     .slots = {{{"longest_h", 17.5}}}},
    {.code = "ice-unknown-on-route",
     .rank = Rank::caution,
     .text = "the ice on {unknown_km:.1f} km of the route is unknown: the vehicle passes there, but the plan "
             "counts on no surfacing",
     .slots = {{{"unknown_km", 12.4}}}},
    // Cautions, not dangers: the planned way itself keeps clear, and only an error of the position leads to the ice.
    {.code = "ice-beside",
     .rank = Rank::caution,
     .text =
         "the position error of {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f} reaches ice where dives "
         "must turn no higher than {turn_m:.0f} m, but the planned dives turn at {planned_turn_m:.0f} m",
     .hint = "Keep the dives below that ice on the whole route (--climb-to {turn_m:.0f}), or limit the time "
             "without surfacing (--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 40.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "ice-beside-needs-deeper-dives",
     .rank = Rank::caution,
     .text =
         "the position error of {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f} reaches ice where dives "
         "must turn no higher than {turn_m:.0f} m, but the planned dives turn at {planned_turn_m:.0f} m",
     .hint = "Keep the dives below that ice on the whole route (--climb-to {turn_m:.0f} --dive-depth "
             "{dive_m:.0f}), or limit the time without surfacing (--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0},
                {"dive_m", 220.0}}}},
    {.code = "ice-beside-too-deep",
     .rank = Rank::caution,
     .text =
         "the position error of {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f} reaches ice where dives "
         "must turn no higher than {turn_m:.0f} m, but the planned dives turn at {planned_turn_m:.0f} m",
     .hint = "This vehicle cannot dive below that ice. Use one that can, or limit the time without surfacing "
             "(--max-time-without-surfacing)",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "surfacings-near-ice",
     .rank = Rank::caution,
     .text = "at {near} of {surfacings} planned surfacings the position error exceeds the distance to ice, "
             "first at {first}: ice at {ice_km:.1f} km, error {error_km:.1f} km",
     .hint = "Surface more often (--surfacing-interval), or keep away from the ice",
     .slots = {{{"near", 2},
                {"surfacings", 4},
                {"first", "2027-01-12T18:00:00Z"},
                {"ice_km", 1.2},
                {"error_km", 2.3}}}},
    {.code = "longer-below-ice-without-leads",
     .rank = Rank::danger,
     .text = "the vehicle could miss the leads that are narrower than its position error. It is then "
             "{sure_h:.0f} h without a place to surface, not {longest_h:.0f} h: no fix, no contact, no "
             "ascent in an "
             "emergency",
     .hint = "Limit that time (--max-time-without-surfacing), or keep away from the ice",
     .slots = {{{"sure_h", 71.0}, {"longest_h", 17.0}}}},
    // A danger: beyond the pilot's own limit, and an error as large as expected is enough.
    {.code = "leads-may-be-missed",
     .rank = Rank::danger,
     .text = "the limit of {bound_h:.1f} h without a place to surface is met only by leads that the vehicle "
             "could miss. Without the leads that are narrower than the position error, the longest time is "
             "{sure_h:.1f} h",
     .hint = "Allow less time (--max-time-without-surfacing), or keep away from the ice",
     .slots = {{{"bound_h", 12.0}, {"sure_h", 19.5}}}},
    {.code = "escapes-end-near-ice",
     .rank = Rank::caution,
     .text = "{near} {near:escape route ends|escape routes end} closer to ice than the position error, first "
             "from waypoint {waypoint}: ice at {ice_km:.1f} km, error {error_km:.1f} km",
     .hint = "Let the vehicle fly on before it surfaces",
     .slots = {{{"near", 6}, {"waypoint", 3}, {"ice_km", 1.2}, {"error_km", 2.3}}}},
    {.code = "surfaces-more-often",
     .rank = Rank::note,
     .text =
         "the fastest route has waypoints without an escape route; this route passes more places to surface"},

    // Icebergs.
    {.code = "sightings-too-old-at-departure",
     .rank = Rank::danger,
     .text = "{ignored} {ignored:iceberg|icebergs} ignored: not seen for too long by the departure at "
             "{departure} ({names}). Each may still be near the route, and the plan avoids none of them",
     .hint = "Depart earlier, ingest newer sightings, or raise the maximum sighting age (--max-sighting-age)",
     .slots = {{{"ignored", 2}, {"departure", "2027-01-12T06:00:00Z"}, {"names", "B-17, B-18"}}}},
    {.code = "drift-unknown-near-route",
     .rank = Rank::caution,
     .text = "{near} of {icebergs} {icebergs:iceberg|icebergs} may come near the route after drifting for a "
             "time without known currents ({names}). During that time each keeps its last observed drift, "
             "drifts with the wind, or stays put",
     .hint = "Ingest newer sightings, or currents that begin earlier and cover a wider area",
     .slots = {{{"near", 3}, {"icebergs", 60}, {"names", "B-17, B-18, B-19"}}}},
    {.code = "drift-unknown-elsewhere",
     .rank = Rank::note,
     .text = "{elsewhere} of {icebergs} {icebergs:iceberg|icebergs} {elsewhere:drifts|drift} for a time "
             "without known currents, but too far away to come near the route",
     .slots = {{{"elsewhere", 57}, {"icebergs", 60}}}},
    // Asked for, and safe when flown as planned: whoever flies it has to know which yo to send.
    {.code = "passes-under-iceberg",
     .rank = Rank::caution,
     .text = "the plan passes under iceberg {iceberg}: no surfacing from {from} to {until}, and dives must "
             "turn no higher than {turn_m:.0f} m",
     .slots = {{{"iceberg", "B-17"},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-12T19:00:00Z"},
                {"turn_m", 60.0}}}},
    {.code = "currents-of-shallower-turns",
     .rank = Rank::caution,
     .text = "below icebergs the dives turn as deep as {turn_m:.0f} m. The energy is computed for that, but "
             "the currents are those of dives that turn at {planned_turn_m:.0f} m",
     .hint = "Plan with --climb-to {turn_m:.0f} to see the difference",
     .slots = {{{"turn_m", 60.0}, {"planned_turn_m", 10.0}}}},

    // Currents.
    {.code = "currents-of-nearest-water",
     .rank = Rank::caution,
     .text = "on {share_pct:.0f} % of the route the current is that of the nearest water in the model, "
             "because the coast of the model is coarser",
     .slots = {{{"share_pct", 4.0}}}},
    {.code = "dives-below-currents",
     .rank = Rank::caution,
     .text =
         "on {unknown_km:.1f} km of the route the dives go below the current model, at worst to {dive_m:.0f} "
         "m where its currents end at {known_m:.0f} m: the mean of its currents is used below",
     .slots = {{{"unknown_km", 12.4}, {"dive_m", 200.0}, {"known_m", 60.0}}}},
    {.code = "hardly-enough-speed",
     .rank = Rank::caution,
     .text = "on {legs} {legs:leg|legs} the current takes more than {enough_pct:.0f} % of the vehicle's "
             "speed to hold the course, most on leg {leg} at {time} ({most_pct:.1f} %): a slightly slower "
             "vehicle drifts off the route there",
     .hint = "Plan with a lower speed (--speed) to keep a reserve",
     .slots = {{{"legs", 1},
                {"enough_pct", 95.0},
                {"leg", 3},
                {"time", "2027-01-12T18:00:00Z"},
                {"most_pct", 98.2}}}},
    {.code = "several-grids-tried",
     .rank = Rank::caution,
     .text = "currents in the area are as fast as the vehicle, so small differences close or open a route. "
             "This plan is the best of several grids",
     .hint = "Another grid spacing (--spacing) or a via point (--via) may give a better one"},
    {.code = "several-grids-agree",
     .rank = Rank::note,
     .text = "currents in the area are as fast as the vehicle, but the plans on several grids differ by less "
             "than {agreement_pct:.0f} %. This plan is the best of them",
     .slots = {{{"agreement_pct", 1.0}}}},
    {.code = "alternative",
     .rank = Rank::note,
     .text = "this route passes {side} of the {obstacle} at {lon_deg:.4f}, {lat_deg:.4f} ({extent_km:.0f} km "
             "across), which the best route leaves on its other side. It takes {difference_h:.1f} h {more}",
     .slots = {{{"side", "south"},
                {"obstacle", "land"},
                {"lon_deg", -53.5},
                {"lat_deg", 69.25},
                {"extent_km", 12.0},
                {"difference_h", 3.2},
                {"more", "more"}}}},
    {.code = "nothing-to-go-round",
     .rank = Rank::note,
     .text =
         "no alternative: nothing of {least_km:.1f} km or more lies beside the route that a vehicle could "
         "leave on its other side",
     .slots = {{{"least_km", 4.2}}}},
    {.code = "few-alternatives",
     .rank = Rank::note,
     .text =
         "fewer alternatives than asked for: {tried} {tried:route|routes} round other sides of obstacles "
         "{tried:was|were} tried. The rest are closed, take more than {longest_h:.0f} h, or hardly differ",
     .slots = {{{"tried", 4}, {"longest_h", 91.0}}}},
    {.code = "may-depart-later",
     .rank = Rank::note,
     .text = "the vehicle may depart {later_h:.1f} h later, at {time}: it arrives no later",
     .slots = {{{"later_h", 2.9}, {"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "route-without-holds",
     .rank = Rank::caution,
     .text = "this vehicle never holds, and something in its way opens later: a route with a hold may arrive "
             "earlier",
     .hint = "Allow holds (--max-hold)"},

    // Uncertain currents.
    {.code = "closed-in-members",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
             "compared route does better",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "closed-members-left-out-of-mean",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
             "compared route does better. The mean leaves these members out",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "share-of-members-not-met",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
             "compared route does better. Fewer members arrive than the {share_pct:.0f} % of the request, so "
             "the route is the best in the mean of those that arrive",
     .slots = {{{"closed", 2}, {"members", 12}, {"share_pct", 90.0}}}},
    {.code = "named-members-not-used",
     .rank = Rank::caution,
     .text = "the plan uses random members around the first of the named currents; the other named currents "
             "were not used",
     .hint = "To plan over the named currents, leave out the number of members (--members)"},
    {.code = "uncertainty-without-members",
     .rank = Rank::caution,
     .text = "the uncertainty of the request has no effect: it has one set of currents and no model of their "
             "errors",
     .hint = "Name several currents (--currents), or give the number of members (--members) and their error "
             "(--current-error)"},
    {.code = "late-in-first-currents",
     .rank = Rank::caution,
     .text = "in the first currents the plan arrives at {arrival}, after the wanted arrival; the "
             "{what_counts} of the members, {counted}, is in time",
     .slots = {{{"arrival", "2027-01-13T18:10:00Z"},
                {"what_counts", "mean"},
                {"counted", "2027-01-13T17:50:00Z"}}}},

    // Times and areas.
    {.code = "early-arrival",
     .rank = Rank::note,
     .text =
         "the plan arrives {early_h:.1f} h before the wanted arrival: no later departure in time was found",
     .slots = {{{"early_h", 3.5}}}},
    {.code = "departures-not-all-planned",
     .rank = Rank::note,
     .text = "{planned} of {departures} departures were planned in full, and this plan is the best of them. "
             "One of the others may be better over all members of the ensemble of currents",
     .hint = "A shorter window plans all of its departures",
     .slots = {{{"departures", 48}, {"planned", 6}}}},
    {.code = "area-opens-just-before",
     .rank = Rank::caution,
     .text = "the plan is at {lon_deg:.4f}, {lat_deg:.4f} only {spare_min:.0f} min after an area reopens "
             "there ({changes}), after {under_way_h:.1f} h under way: a vehicle {error_pct:.0f} % faster "
             "than planned breaks the rule of the area",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"spare_min", 12.0},
                {"changes", "2027-01-12T18:00:00Z"},
                {"under_way_h", 12.2},
                {"error_pct", 5.0}}}},
    {.code = "area-closes-just-after",
     .rank = Rank::caution,
     .text = "the plan is at {lon_deg:.4f}, {lat_deg:.4f} only {spare_min:.0f} min before an area closes "
             "there ({changes}), after {under_way_h:.1f} h under way: a vehicle {error_pct:.0f} % slower "
             "than planned breaks the rule of the area",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"spare_min", 12.0},
                {"changes", "2027-01-12T18:00:00Z"},
                {"under_way_h", 12.2},
                {"error_pct", 5.0}}}},

    // The battery. These are cautions, not dangers, because the reserve that is kept for a recovery is not counted.
    {.code = "battery-too-small",
     .rank = Rank::caution,
     .text = "the plan draws {drawn_mj:.2f} MJ, {missing_mj:.2f} MJ more than the {usable_mj:.2f} MJ above "
             "the battery's reserve",
     .hint = "Start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter route",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.25}, {"usable_mj", 1.0}}}},
    {.code = "battery-below-reserve",
     .rank = Rank::caution,
     .text = "the plan draws {drawn_mj:.2f} MJ, but the battery begins {missing_mj:.2f} MJ below its reserve",
     .hint = "Start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter route",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.1}}}},
    {.code = "battery-too-small-for-escape",
     .rank = Rank::caution,
     .text = "the escape route from waypoint {waypoint} draws {drawn_mj:.2f} MJ, but only {left_mj:.2f} MJ "
             "are left there above the battery's reserve",
     .hint = "Start with a fuller battery, plan a route nearer to open water, or plan without escape routes "
             "(--escape-plan)",
     .slots = {{{"waypoint", 3}, {"drawn_mj", 0.4}, {"left_mj", 0.25}}}},

    // How the way was looked for.
    {.code = "search-cut-short",
     .rank = Rank::note,
     .text = "the search reached the limit of its work: a better route may exist"},
    {.code = "search-cut-short-near-the-best",
     .rank = Rank::note,
     .text = "the search reached the limit of its work: a better route may exist, faster by at most "
             "{gain_min:.0f} min ({gain_pct:.1f} %) before refinement",
     .slots = {{{"gain_min", 4.0}, {"gain_pct", 0.3}}}},
    {.code = "cost-search-cut-short",
     .rank = Rank::note,
     .text = "the search reached the limit of its work: a plan of lower cost may exist"},
    {.code = "route-not-refined",
     .rank = Rank::note,
     .text = "the route keeps to the lines of the search grid. A route off these lines would be faster, but "
             "it would break a limit of the request, such as the longest time without a place to surface",
     .hint = "A smaller grid spacing (--spacing) may give a faster route"},
    {.code = "more-waypoints-than-asked",
     .rank = Rank::caution,
     .text = "the route needs more waypoints than requested: with fewer it would be closed or have legs that "
             "are too long"},

    // Isochrones: an area that is too small keeps nobody from a plan, so most of this is a note.
    {.code = "areas-in-strong-currents",
     .rank = Rank::note,
     .text = "currents in the area are as fast as the vehicle. They close whole legs of the grid, so the "
             "areas may be a few per cent too small",
     .hint = "Another grid spacing (--spacing) may show more"},
    {.code = "areas-to-a-place-in-strong-currents",
     .rank = Rank::note,
     .text = "currents in the area are as fast as the vehicle. They close whole legs of the grid, so the "
             "areas may be a few per cent too small. Places may be missing from which the vehicle is in time "
             "only because a closed route reopens",
     .hint = "Another grid spacing (--spacing) may show more"},
    {.code = "areas-beyond-battery",
     .rank = Rank::caution,
     .text = "the {usable_mj:.2f} MJ above the battery's reserve last at most {lasts_h:.1f} h: the areas of "
             "longer times are beyond the battery",
     .slots = {{{"usable_mj", 1.0}, {"lasts_h", 96.0}}}},
    {.code = "areas-cut-short",
     .rank = Rank::note,
     .text = "the search was cut short: the true areas may be larger",
     .hint = "A larger grid spacing (--spacing) helps"},
    {.code = "areas-cut-at-the-data",
     .rank = Rank::note,
     .text = "the area ends at the edge of the data; currents carry the vehicle farther"},

    // Words that came with a request or a file, or from a plan that was stored before there were codes.
    {.code = "remark",
     .rank = Rank::note,
     .text = "{remark}",
     .slots = {{{"remark", "read from track.gpx"}}}},
    {.code = "mission-file-note",
     .rank = Rank::note,
     .text = "{remark}",
     .slots =
         {{{"remark",
            "A goto list ends below ice, where no vehicle can come up: the next one is flown at once."}}}},
    {.code = "speed-not-made",
     .rank = Rank::caution,
     .text = "No plausible drag explains the planned speed with this pump and pitch. The flight uses the "
             "drag of the vehicle profile, so the vehicle is slower or faster than planned."},
    {.code = "earlier-danger",
     .rank = Rank::danger,
     .text = "{remark}",
     .slots = {{{"remark", "as it was stored"}}}},
    {.code = "earlier-warning",
     .rank = Rank::caution,
     .text = "{remark}",
     .slots = {{{"remark", "as it was stored"}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message plan_message(const Given&... given) {
  return make_message<plan_kinds, code>(given...);
}

}  // namespace floeplan::messages
