#pragma once

#include "engine/messages/kind.hpp"

/// Why there is no plan for a valid request, and what would help.
/// Ranks    caution: what stands in the way, which the pilot has to change something about. Nothing is flown, so nothing
///          is a danger. Note: what the search has to say besides
namespace floeplan::messages {

inline constexpr auto refusal_kinds = std::to_array<Kind>({
    // On the way.
    {.code = "current-too-strong",
     .rank = Rank::caution,
     .text = "the current here is too strong for {speed_m_s:.2f} m/s through the water",
     .hint = "depart at another time, raise the speed, or choose a way with weaker current",
     .slots = {{{"speed_m_s", 0.35}}}},
    {.code = "currents-end-before-the-route",
     .rank = Rank::caution,
     .text = "the stored currents end at {end}, before the route does",
     .hint = "depart earlier, ingest a longer forecast, or hold the currents steady (--steady)",
     .slots = {{{"end", "2027-01-14T00:00:00Z"}}}},
    {.code = "way-outside-data",
     .rank = Rank::caution,
     .text = "the stored data do not cover this place, or not at this time",
     .hint = "ingest data that cover it, or leave the kind of data out (for example --currents none)"},
    {.code = "way-too-shallow",
     .rank = Rank::caution,
     .text = "the water is shallower than the vehicle's minimum of {least_m:.0f} m",
     .hint = "go round it, or choose a vehicle for shallower water",
     .slots = {{{"least_m", 10.0}}}},
    {.code = "way-on-land", .rank = Rank::caution, .text = "the way crosses land", .hint = "go round it"},
    {.code = "way-in-zone",
     .rank = Rank::caution,
     .text = "the way breaks the rule of a zone",
     .hint = "go round it, or change the zone or its times"},
    {.code = "no-room-below-ice",
     .rank = Rank::caution,
     .text = "the vehicle cannot pass below the ice: there is no room of {room_m:.0f} m between the sea bed "
             "and the turn it must make {margin_m:.0f} m below the deepest keel, or its dives do not reach "
             "that deep",
     .hint = "dive deeper (--dive-depth), go round it, or change what is kept from the ice (under_ice)",
     .slots = {{{"room_m", 25.0}, {"margin_m", 10.0}}}},
    {.code = "too-long-without-surfacing",
     .rank = Rank::caution,
     .text = "the vehicle would be longer than {bound_h:.4g} h without a place where it may surface",
     .hint = "allow more time (--max-time-without-surfacing) or denser ice to surface in "
             "(--max-concentration-to-surface), or depart at another time",
     .slots = {{{"bound_h", 12.0}}}},
    {.code = "way-near-iceberg",
     .rank = Rank::caution,
     .text = "the way comes too close to {iceberg}",
     .hint = "go round it, depart at another time, or reduce the margin (--margin) or the error that is "
             "allowed for (--max-inflation)",
     .slots = {{{"iceberg", "an iceberg"}}}},

    // A start, a goal or a via point.
    {.code = "place-on-land",
     .rank = Rank::caution,
     .text = "{place} lies on land in the stored bathymetry or coastline",
     .hint = "move it into the water; longitude comes first",
     .slots = {{{"place", "the goal"}}}},
    {.code = "place-too-shallow",
     .rank = Rank::caution,
     .text = "{place} lies in water shallower than the vehicle's minimum of {least_m:.0f} m",
     .hint = "move it into deeper water, or choose a vehicle for shallower water",
     .slots = {{{"place", "the goal"}, {"least_m", 10.0}}}},
    {.code = "place-in-zone",
     .rank = Rank::caution,
     .text = "{place} lies where a zone does not allow the vehicle to be{until}",
     .hint = "move it, change the zone or its times, or depart when it allows the vehicle to be there",
     .slots = {{{"place", "the goal"}, {"until", ", until 2027-01-12T18:00:00Z"}}}},
    {.code = "place-near-iceberg",
     .rank = Rank::caution,
     .text = "{place} lies too close to {iceberg}{until}",
     .hint = "move it, depart at another time, or reduce the margin (--margin) or the error that is allowed "
             "for (--max-inflation)",
     .slots =
         {{{"place", "the goal"}, {"iceberg", "an iceberg"}, {"until", ", until 2027-01-12T18:00:00Z"}}}},
    {.code = "place-outside-data",
     .rank = Rank::caution,
     .text = "{place} lies outside the stored data",
     .hint = "ingest data that cover it, or leave the kind of data out (for example --bathymetry none)",
     .slots = {{{"place", "the goal"}}}},

    // What opens only after the vehicle could be there.
    {.code = "place-in-zone-opens-later",
     .rank = Rank::caution,
     .text = "{place} lies where a zone does not allow the vehicle to be at {time}{until}; the vehicle, "
             "which is there earlier, would have to turn in circles for {circling_h:.4g} h",
     .hint = "depart later, let the vehicle wait (--max-loiter), move the {moved}, or change the zone or "
             "its times",
     .slots = {{{"place", "the goal"},
                {"time", "2027-01-12T12:00:00Z"},
                {"until", ", until 2027-01-12T18:00:00Z"},
                {"circling_h", 6.0},
                {"moved", "goal"}}}},
    {.code = "way-in-zone-opens-later",
     .rank = Rank::caution,
     .text = "the way leads where a zone does not allow the vehicle to be at {time}; the vehicle, which is "
             "there earlier, would have to turn in circles for {circling_h:.4g} h",
     .hint = "depart later, let the vehicle wait (--max-loiter), move the {moved}, or change the zone or "
             "its times",
     .slots = {{{"time", "2027-01-12T12:00:00Z"}, {"circling_h", 6.0}, {"moved", "goal"}}}},
    {.code = "place-near-iceberg-opens-later",
     .rank = Rank::caution,
     .text = "{place} lies too close to {iceberg}{until}; the vehicle, which is there earlier, would have "
             "to turn in circles for {circling_h:.4g} h",
     .hint = "depart later, let the vehicle wait (--max-loiter), move the {moved}, or reduce the margin "
             "(--margin) or the error that is allowed for (--max-inflation)",
     .slots = {{{"place", "the goal"},
                {"iceberg", "an iceberg"},
                {"until", ", until 2027-01-12T18:00:00Z"},
                {"circling_h", 6.0},
                {"moved", "goal"}}}},
    {.code = "way-near-iceberg-opens-later",
     .rank = Rank::caution,
     .text = "the way leads too close to {iceberg}; the vehicle, which is there earlier, would have to turn "
             "in circles for {circling_h:.4g} h",
     .hint = "depart later, let the vehicle wait (--max-loiter), move the {moved}, or reduce the margin "
             "(--margin) or the error that is allowed for (--max-inflation)",
     .slots = {{{"iceberg", "an iceberg"}, {"circling_h", 6.0}, {"moved", "goal"}}}},

    // Of a search. What closes most of the ways is told in the words of the row for a way.
    {.code = "no-way-to-goal",
     .rank = Rank::caution,
     .text = "no way was found to the goal; the nearest place reached is marked, where {closed}",
     .hint = "{help}; a finer grid (--spacing) finds narrower passages",
     .slots = {{{"closed", "the way crosses land"}, {"help", "go round it"}}}},
    {.code = "no-way-through-currents",
     .rank = Rank::caution,
     .text = "no way was found to the goal; the nearest place reached is marked, where {closed}",
     .hint = "{help}; a place to pass (--via) has ways looked for further round",
     .slots = {{{"closed", "the current here is too strong for 0.35 m/s through the water"},
                {"help", "depart at another time"}}}},
    {.code = "no-way-within-memory",
     .rank = Rank::caution,
     .text = "no way was found to the goal; the nearest place reached is marked, where {closed}",
     .hint = "{help}; a coarser grid (--spacing) needs less memory",
     .slots = {{{"closed", "the way crosses land"}, {"help", "go round it"}}}},
    {.code = "no-way-before-current-eases",
     .rank = Rank::caution,
     .text = "no way was found to the goal: {closed}",
     .hint = "depart later, let the vehicle wait (--max-loiter), or have the departure searched in a window "
             "(--depart-until)",
     .slots = {{{"closed",
                 "the current at -60.2500,69.5000 is too strong for the vehicle when it could be there"}}}},
    {.code = "no-way-within-wait",
     .rank = Rank::caution,
     .text = "no way was found to the goal: {closed}",
     .hint = "depart later, let the vehicle wait longer (--max-loiter), or have the departure searched in a "
             "window (--depart-until)",
     .slots = {{{"closed",
                 "the current at -60.2500,69.5000 is too strong for the vehicle when it could be there"}}}},
    {.code = "no-escape",
     .rank = Rank::caution,
     .text = "from this waypoint no way leads to a place where the vehicle may surface, within 200 steps of "
             "the grid",
     .hint = "allow denser ice to surface in (--max-concentration-to-surface), choose a wider spacing, or "
             "plan without --escape-plan"},
    {.code = "no-escape-in-time",
     .rank = Rank::caution,
     .text = "from this waypoint no way leads to a place where the vehicle may surface before it has been "
             "{bound_h:.4g} h without one, within 200 steps of the grid",
     .hint = "allow more time (--max-time-without-surfacing) or denser ice to surface in "
             "(--max-concentration-to-surface), choose a wider spacing, or plan without --escape-plan",
     .slots = {{{"bound_h", 12.0}}}},
    {.code = "earliest-departure-too-late",
     .rank = Rank::caution,
     .text = "leaving at {depart}, the earliest departure, arrives at {arrival}",
     .hint = "arrive by then or later, allow an earlier departure (--depart), or raise the speed",
     .slots = {{{"depart", "2027-01-12T06:00:00Z"}, {"arrival", "2027-01-13T18:10:00Z"}}}},
    {.code = "earliest-departure-in-too-few-members",
     .rank = Rank::caution,
     .text = "leaving at {depart}, the earliest departure, arrives in too few of the members of the currents",
     .hint = "arrive by then or later, allow an earlier departure (--depart), or raise the speed",
     .slots = {{{"depart", "2027-01-12T06:00:00Z"}}}},
    {.code = "grid-too-large",
     .rank = Rank::caution,
     .text = "the grid would have {vertices_millions:.0f} million vertices, more than memory is set aside "
             "for",
     .hint = "choose a wider spacing or plan in parts",
     .slots = {{{"vertices_millions", 120.0}}}},
    {.code = "too-many-icebergs",
     .rank = Rank::caution,
     .text = "the area holds {icebergs} icebergs, more than are forecast at once",
     .hint = "plan in parts, or use younger sightings only (--max-sighting-age)",
     .slots = {{{"icebergs", 25000}}}},
    {.code = "cancelled", .rank = Rank::note, .text = "the search was cancelled", .hint = "start it again"},

    // Besides. A hint of these counts instead of that of what stands in the way.
    {.code = "way-without-icebergs",
     .rank = Rank::note,
     .text = "without icebergs there would be a way",
     .hint = "depart at another time, or reduce the margin (--margin) or the error that is allowed for "
             "(--max-inflation)"},
    {.code = "way-without-zones",
     .rank = Rank::note,
     .text = "without zones there would be a way",
     .hint = "change the zones or their times"},
    {.code = "way-without-ice",
     .rank = Rank::note,
     .text = "without ice there would be a way",
     .hint = "dive deeper (--dive-depth), or change what is kept from the ice (under_ice)"},
    {.code = "way-without-currents",
     .rank = Rank::note,
     .text = "without currents there would be a way",
     .hint = "depart at another time, or raise the speed"},
    {.code = "search-without-end",
     .rank = Rank::note,
     .text = "the search was cut short at its bound on memory: there may be a way all the same"},
    {.code = "searched-from-stop-to-stop",
     .rank = Rank::note,
     .text = "the way was looked for from stop to stop, as early at each as it can be: there may be one "
             "that comes to a stop later, all the same"},
    {.code = "area-searched",
     .rank = Rank::note,
     .text = "ways were looked for no further than {beside_km:.0f} km beside the straight line and beyond "
             "its ends",
     .slots = {{{"beside_km", 104.0}}}},
    {.code = "other-orders-tried",
     .rank = Rank::note,
     .text = "this is of the order given; of the orders that promised more, {orders} were tried, too, and "
             "none has a plan",
     .slots = {{{"orders", 4}}}},
    {.code = "departures-tried",
     .rank = Rank::note,
     .text = "{tried} of {departures} departures were tried, {left} with a way were not: a shorter window "
             "looks at them",
     .slots = {{{"tried", 24}, {"departures", 31}, {"left", 3}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message refusal(const Given&... given) {
  return make_message<refusal_kinds, code>(given...);
}

/// Parts of these messages, which are told as values of theirs.
inline constexpr auto phrase_kinds = std::to_array<Kind>({
    {.code = "an-iceberg", .rank = Rank::note, .text = "an iceberg"},
    {.code = "iceberg-with-margin",
     .rank = Rank::note,
     .text = "{iceberg} at {time}, from whose hull {margin_m:.0f} m of margin are kept",
     .slots = {{{"iceberg", "iceberg B-17"}, {"time", "2027-01-12T12:00:00Z"}, {"margin_m", 500.0}}}},
    {.code = "iceberg-with-margin-and-error",
     .rank = Rank::note,
     .text = "{iceberg} at {time}, from whose hull {margin_m:.0f} m of margin and {error_m:.0f} m for the "
             "error of its position are kept",
     .slots = {{{"iceberg", "iceberg B-17"},
                {"time", "2027-01-12T12:00:00Z"},
                {"margin_m", 500.0},
                {"error_m", 3000.0}}}},
    {.code = "until",
     .rank = Rank::note,
     .text = ", until {time}",
     .slots = {{{"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "for-good", .rank = Rank::note, .text = ", as far as is forecast for good"},
});

template <Code code, class... Given>
[[nodiscard]] std::string phrase(const Given&... given) {
  return make_message<phrase_kinds, code>(given...).text;
}

}  // namespace floeplan::messages
