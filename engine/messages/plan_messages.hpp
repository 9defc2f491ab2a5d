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
     .text = "the start lies under ice: the vehicle may not surface at the departure, and the plan can "
             "begin only where it is brought below the ice",
     .hint = "Move the start to open water; the simulator flies no plan that begins under ice"},
    {.code = "start-ice-unknown",
     .rank = Rank::caution,
     .text = "the vehicle may not surface at the departure, as far as is known: nothing is known of the ice "
             "there",
     .hint = "Make sure that the water is open"},
    {.code = "goal-under-ice",
     .rank = Rank::danger,
     .text = "the goal lies under ice: the vehicle may not surface at the goal",
     .hint = "Move the goal to open water"},
    {.code = "goal-ice-unknown",
     .rank = Rank::caution,
     .text =
         "the vehicle may not surface at the goal, as far as is known: nothing is known of the ice there"},
    {.code = "vias-under-ice",
     .rank = Rank::danger,
     .text = "{under} of {vias} {vias:via point lies|via points lie} under ice (number {numbers}): the "
             "vehicle may not surface there",
     .hint = "Move them to open water, or make sure that it need not surface",
     .slots = {{{"under", 1}, {"vias", 3}, {"numbers", "2"}}}},
    {.code = "long-below-ice",
     .rank = Rank::danger,
     .text = "for {longest_h:.1f} h the vehicle finds no place to surface below the ice: no fix, no "
             "contact, and no way up in an emergency",
     .hint = "Bound that time (--max-time-without-surfacing), or keep off the ice",
     .slots = {{{"longest_h", 17.5}}}},
    {.code = "ice-unknown-on-route",
     .rank = Rank::caution,
     .text = "nothing is known of the ice on {unknown_km:.1f} km of the route: passed, but not counted on "
             "for surfacing",
     .slots = {{{"unknown_km", 12.4}}}},
    // Cautions, not dangers: the planned way itself keeps clear, and only an error of the position leads to the ice.
    {.code = "ice-beside",
     .rank = Rank::caution,
     .text = "within the error of its position, {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f}, the "
             "vehicle may come below ice where dives must turn no higher than {turn_m:.0f} m, yet those of "
             "the plan turn at {planned_turn_m:.0f} m:",
     .hint = "keep below that ice all the way (--climb-to {turn_m:.0f}), or bound the time without surfacing",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 40.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "ice-beside-needs-deeper-dives",
     .rank = Rank::caution,
     .text = "within the error of its position, {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f}, the "
             "vehicle may come below ice where dives must turn no higher than {turn_m:.0f} m, yet those of "
             "the plan turn at {planned_turn_m:.0f} m:",
     .hint = "keep below that ice all the way (--climb-to {turn_m:.0f} --dive-depth {dive_m:.0f}), or bound "
             "the time without surfacing",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0},
                {"dive_m", 220.0}}}},
    {.code = "ice-beside-too-deep",
     .rank = Rank::caution,
     .text = "within the error of its position, {error_km:.1f} km at {lon_deg:.4f}, {lat_deg:.4f}, the "
             "vehicle may come below ice where dives must turn no higher than {turn_m:.0f} m, yet those of "
             "the plan turn at {planned_turn_m:.0f} m:",
     .hint = "this vehicle cannot dive below that ice; take one that can, or bound the time without "
             "surfacing",
     .slots = {{{"error_km", 2.1},
                {"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"turn_m", 190.0},
                {"planned_turn_m", 10.0}}}},
    {.code = "surfacings-near-ice",
     .rank = Rank::caution,
     .text = "{near} of {surfacings} planned surfacings have ice nearer than the position may be off, the "
             "first of them at {first}: ice at {ice_km:.1f} km, error {error_km:.1f} km",
     .hint = "surface more often (--surfacing-interval), or keep off the ice",
     .slots = {{{"near", 2},
                {"surfacings", 4},
                {"first", "2027-01-12T18:00:00Z"},
                {"ice_km", 1.2},
                {"error_km", 2.3}}}},
    {.code = "leads-may-be-missed",
     .rank = Rank::caution,
     .text = "the bound of {bound_h:.1f} h without a place to surface is kept by openings in the ice that "
             "the vehicle may miss: counting those that are wider than the error of its position it is "
             "{sure_h:.1f} h",
     .hint = "allow less time (--max-time-without-surfacing), or keep off the ice",
     .slots = {{{"bound_h", 12.0}, {"sure_h", 19.5}}}},
    {.code = "escapes-end-near-ice",
     .rank = Rank::caution,
     .text = "{near} escapes end nearer to ice than the position may be off by then, the first of them from "
             "waypoint {waypoint}: ice at {ice_km:.1f} km, error {error_km:.1f} km",
     .hint = "have the vehicle go on before it comes up",
     .slots = {{{"near", 6}, {"waypoint", 3}, {"ice_km", 1.2}, {"error_km", 2.3}}}},
    {.code = "surfaces-more-often",
     .rank = Rank::note,
     .text = "the fastest way leaves no escape from every waypoint; this one comes to places to surface "
             "more often"},

    // Icebergs.
    {.code = "sightings-too-old-at-departure",
     .rank = Rank::danger,
     .text = "{ignored} {ignored:iceberg|icebergs} ignored: not seen for too long by the departure at "
             "{departure} ({names}). Each may still be near the route, and the plan avoids none of them",
     .hint = "Depart earlier, ingest newer sightings, or raise the maximum sighting age (--max-sighting-age)",
     .slots = {{{"ignored", 2}, {"departure", "2027-01-12T06:00:00Z"}, {"names", "B-17, B-18"}}}},
    // Asked for, and safe when flown as planned: whoever flies it has to know which yo to send.
    {.code = "passes-under-iceberg",
     .rank = Rank::caution,
     .text = "the plan passes under iceberg {iceberg}: no surfacing from {from} to {until}, and dives that "
             "turn no higher than {turn_m:.0f} m",
     .slots = {{{"iceberg", "B-17"},
                {"from", "2027-01-12T18:00:00Z"},
                {"until", "2027-01-12T19:00:00Z"},
                {"turn_m", 60.0}}}},
    {.code = "currents-of-shallower-turns",
     .rank = Rank::caution,
     .text = "below icebergs the dives turn as deep as {turn_m:.0f} m, and the energy is reckoned so; the "
             "currents are those of dives that turn at {planned_turn_m:.0f} m:",
     .hint = "plan with --climb-to {turn_m:.0f} to see how much that matters",
     .slots = {{{"turn_m", 60.0}, {"planned_turn_m", 10.0}}}},

    // Currents.
    {.code = "currents-of-nearest-water",
     .rank = Rank::caution,
     .text = "on {share_pct:.0f} % of the route the current is that of the nearest water in the model, "
             "whose coast is coarser",
     .slots = {{{"share_pct", 4.0}}}},
    {.code = "dives-below-currents",
     .rank = Rank::caution,
     .text = "on {unknown_km:.1f} km of the route dives go much deeper than the model's water, at worst to "
             "{dive_m:.0f} m where its currents are known to {known_m:.0f} m: those are taken all the way "
             "down",
     .slots = {{{"unknown_km", 12.4}, {"dive_m", 200.0}, {"known_m", 60.0}}}},
    {.code = "hardly-enough-speed",
     .rank = Rank::caution,
     .text = "on {legs} {legs:leg|legs} the current takes more than {enough_pct:.0f} % of the vehicle's "
             "speed to hold the course, most on leg {leg} at {time}, {most_pct:.1f} %: a vehicle a little "
             "slower is carried away there",
     .hint = "plan with a lower speed to keep some in reserve",
     .slots = {{{"legs", 1},
                {"enough_pct", 95.0},
                {"leg", 3},
                {"time", "2027-01-12T18:00:00Z"},
                {"most_pct", 98.2}}}},
    {.code = "several-grids-tried",
     .rank = Rank::caution,
     .text = "currents somewhere in the area are as fast as the vehicle: a little closes or opens a way, "
             "and this plan is the best of those on several grids",
     .hint = "another --spacing, or a place to pass (--via), may lead to a better one"},
    {.code = "leg-opens-later",
     .rank = Rank::note,
     .text = "the current at {lon_deg:.4f},{lat_deg:.4f} is too strong for the vehicle when it could be "
             "there ({refused}) and lets it through from {opens} on",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"refused", "2027-01-12T18:00:00Z"},
                {"opens", "2027-01-12T21:00:00Z"}}}},
    {.code = "leg-opens-later-and-is-faster",
     .rank = Rank::note,
     .text = "the current at {lon_deg:.4f},{lat_deg:.4f} is too strong for the vehicle when it could be "
             "there ({refused}) and lets it through from {opens} on; coming later would be {gain_h:.1f} h "
             "faster there",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"refused", "2027-01-12T18:00:00Z"},
                {"opens", "2027-01-12T21:00:00Z"},
                {"gain_h", 1.5}}}},
    {.code = "way-round-what-opens-later",
     .rank = Rank::note,
     .text = "between waypoints {from} and {to} the route detours {longer_h:.1f} h round an obstacle that "
             "clears later:",
     .hint = "let the vehicle wait (--max-loiter), or depart later",
     .slots = {{{"from", 2}, {"to", 4}, {"longer_h", 2.9}}}},

    // Uncertain currents.
    {.code = "closed-in-members",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
             "compared route reaches it in more of them",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "closed-members-left-out-of-mean",
     .rank = Rank::caution,
     .text = "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
             "compared route reaches it in more of them: the mean leaves them out",
     .slots = {{{"closed", 2}, {"members", 12}}}},
    {.code = "share-of-members-not-met",
     .rank = Rank::caution,
     .text =
         "in {closed} of {members} members the vehicle does not reach the goal on this route, and no "
         "compared route reaches it in more of them: fewer members arrive than the {share_pct:.0f} % that "
         "the request counts, and the route is the best in the mean of those that arrive",
     .slots = {{{"closed", 2}, {"members", 12}, {"share_pct", 90.0}}}},
    {.code = "named-members-not-used",
     .rank = Rank::caution,
     .text = "members were drawn about the first of the currents alone; the others that are named were not "
             "used"},
    {.code = "uncertainty-without-members",
     .rank = Rank::caution,
     .text = "nothing was made of the uncertainty that was asked about: there is one set of currents and no "
             "model of its errors",
     .hint = "name several currents, or say how many members to draw and how large the errors are"},
    {.code = "late-in-first-currents",
     .rank = Rank::caution,
     .text = "in the currents that the plan is made with it arrives at {arrival}, after the wanted arrival: "
             "what counts is the {what_counts} of the members, {counted}",
     .slots = {{{"arrival", "2027-01-13T18:10:00Z"},
                {"what_counts", "mean"},
                {"counted", "2027-01-13T17:50:00Z"}}}},

    // Times and areas.
    {.code = "early-arrival",
     .rank = Rank::note,
     .text = "this plan is there {early_h:.1f} h before the wanted arrival: no later departure was found "
             "that is in time",
     .slots = {{{"early_h", 3.5}}}},
    {.code = "departures-not-all-planned",
     .rank = Rank::note,
     .text = "of {departures} departures {planned} were planned whole, and this is the best of them; the "
             "members' own best ways leave open whether another is better:",
     .hint = "a shorter window looks at all of its own",
     .slots = {{{"departures", 48}, {"planned", 6}}}},
    {.code = "area-opens-just-before",
     .rank = Rank::caution,
     .text = "the plan is at {lon_deg:.4f}, {lat_deg:.4f} only {spare_min:.0f} min after an area opens "
             "there ({changes}), after {under_way_h:.1f} h under way: a vehicle {error_pct:.0f} % faster "
             "than planned would break its rule",
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
             "than planned would break its rule",
     .slots = {{{"lon_deg", -60.25},
                {"lat_deg", 69.5},
                {"spare_min", 12.0},
                {"changes", "2027-01-12T18:00:00Z"},
                {"under_way_h", 12.2},
                {"error_pct", 5.0}}}},

    // The battery. Cautions: the reserve, which is kept for a recovery, is left out of what it gives.
    {.code = "battery-too-small",
     .rank = Rank::caution,
     .text = "the plan draws {drawn_mj:.2f} MJ, {missing_mj:.2f} MJ more than the {usable_mj:.2f} MJ that "
             "the battery gives above its reserve",
     .hint = "start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter way",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.25}, {"usable_mj", 1.0}}}},
    {.code = "battery-below-reserve",
     .rank = Rank::caution,
     .text = "the plan draws {drawn_mj:.2f} MJ, and the battery begins {missing_mj:.2f} MJ below its reserve",
     .hint = "start with a fuller battery, save energy (--objective energy, --thruster off, deeper dives), "
             "or plan a shorter way",
     .slots = {{{"drawn_mj", 1.25}, {"missing_mj", 0.1}}}},
    {.code = "battery-too-small-for-escape",
     .rank = Rank::caution,
     .text = "the way to open water from waypoint {waypoint} draws {drawn_mj:.2f} MJ, but {left_mj:.2f} MJ "
             "are left there above the battery's reserve",
     .hint = "start with a fuller battery, plan a way nearer to open water, or plan without --escape-plan",
     .slots = {{{"waypoint", 3}, {"drawn_mj", 0.4}, {"left_mj", 0.25}}}},

    // How the way was looked for.
    {.code = "search-cut-short",
     .rank = Rank::note,
     .text = "the search for better ways was cut short at its bound on memory: there may be one"},
    {.code = "search-cut-short-near-the-best",
     .rank = Rank::note,
     .text = "the search for better ways was cut short at its bound on memory: there may be one, by "
             "{gain_min:.0f} min ({gain_pct:.1f} %) at most before refinement",
     .slots = {{{"gain_min", 4.0}, {"gain_pct", 0.3}}}},
    {.code = "cost-search-cut-short",
     .rank = Rank::note,
     .text = "the search met its bound on memory before it was done; a plan that costs less may exist"},
    {.code = "refinement-out-of-time",
     .rank = Rank::note,
     .text = "refinement ran out of its time",
     .hint = "with more, or on another machine, the route may be a little better"},
    {.code = "route-not-refined",
     .rank = Rank::note,
     .text = "the route is not refined: refined routes are faster, but break a rule that holds for the whole "
             "route, such as the longest time without a place to surface"},
    {.code = "more-waypoints-than-asked",
     .rank = Rank::caution,
     .text = "the route needs more waypoints than asked for; without them it would be closed or have longer "
             "legs than allowed"},

    // Isochrones: an area that is too small keeps nobody from a plan, so most of this is a note.
    {.code = "areas-in-strong-currents",
     .rank = Rank::note,
     .text = "currents somewhere in the area are as fast as the vehicle: whole legs of the grid are closed "
             "in them, and the areas may be some per cent smaller than the truth",
     .hint = "another --spacing may show more"},
    {.code = "areas-to-a-place-in-strong-currents",
     .rank = Rank::note,
     .text = "currents somewhere in the area are as fast as the vehicle: whole legs of the grid are closed "
             "in them, and the areas may be some per cent smaller than the truth; places from which the "
             "vehicle is in time only because a current that closes its way opens again later may be missing",
     .hint = "another --spacing may show more"},
    {.code = "areas-beyond-battery",
     .rank = Rank::caution,
     .text = "the {usable_mj:.2f} MJ that the battery gives above its reserve last {lasts_h:.1f} h at most: "
             "what takes longer is beyond it",
     .slots = {{{"usable_mj", 1.0}, {"lasts_h", 96.0}}}},
    {.code = "areas-cut-short",
     .rank = Rank::note,
     .text = "the search was cut short: more may be within reach",
     .hint = "a larger --spacing helps"},
    {.code = "areas-cut-at-the-data",
     .rank = Rank::note,
     .text = "the area is cut where it leaves the data that were looked at: currents carry the vehicle "
             "further"},

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
     .text = "No drag that a glider can have explains the speed that the plan counts on with this pump and "
             "pitch: the vehicle was flown with the drag of its profile, and is slower or faster than "
             "planned."},
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
