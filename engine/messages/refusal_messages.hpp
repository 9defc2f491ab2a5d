#pragma once

#include "engine/messages/kind.hpp"

/// Why a valid request has no plan, and what would help.
/// Ranks    caution: what closes the route, so that the pilot must change something. Nothing is flown, so
///          nothing is a danger. Note: further findings of the search
namespace floeplan::messages {

inline constexpr auto refusal_kinds = std::to_array<Kind>({
    // On the route.
    {.code = "current-too-strong",
     .rank = Rank::caution,
     .text = "the current is too strong for a vehicle with {speed_m_s:.2f} m/s through the water",
     .hint = "Depart at another time, raise the speed, or choose a route with weaker current",
     .slots = {{{"speed_m_s", 0.35}}}},
    {.code = "currents-end-before-the-route",
     .rank = Rank::caution,
     .text = "the stored currents end at {end}, before the route ends",
     .hint = "Ingest a longer forecast, or hold the currents steady (--steady)",
     .slots = {{{"end", "2027-01-14T00:00:00Z"}}}},
    {.code = "way-outside-data",
     .rank = Rank::caution,
     .text = "the stored data do not cover this place at this time",
     .hint =
         "Ingest data that cover this place and time. The list of datasets shows their areas and periods"},
    {.code = "way-too-shallow",
     .rank = Rank::caution,
     .text = "the water is shallower than the vehicle's minimum of {least_m:.0f} m",
     .hint = "Lead the route round this water (--via), or choose a vehicle for shallower water",
     .slots = {{{"least_m", 10.0}}}},
    {.code = "way-on-land",
     .rank = Rank::caution,
     .text = "the route crosses land",
     .hint = "Lead the route round the land (--via)"},
    {.code = "way-in-zone",
     .rank = Rank::caution,
     .text = "the route breaks the rule of a zone",
     .hint = "Lead the route round the zone (--via), or change the zone or its times"},
    {.code = "no-room-below-ice",
     .rank = Rank::caution,
     .text = "the vehicle cannot pass below the ice. The upper turn of its dives must be {margin_m:.0f} m "
             "below the deepest keel. The dives do not reach that deep, or less than {room_m:.0f} m of water "
             "lie between this turn and the sea bed",
     .hint = "Dive deeper (--dive-depth), lead the route round the ice (--via), or reduce the clearance "
             "below ice (--margin-below-ice)",
     .slots = {{{"room_m", 25.0}, {"margin_m", 10.0}}}},
    {.code = "too-long-without-surfacing",
     .rank = Rank::caution,
     .text = "the vehicle would be without a place to surface for more than {bound_h:duration}",
     .hint = "Allow more time (--max-time-without-surfacing) or surfacing in denser ice "
             "(--max-concentration-to-surface), or depart at another time",
     .slots = {{{"bound_h", 12.0}}}},
    {.code = "way-near-iceberg",
     .rank = Rank::caution,
     .text = "the route comes too close to {iceberg}",
     .hint = "Lead the route round the iceberg (--via), depart at another time, or reduce the margin "
             "(--margin) or the position allowance (--max-inflation)",
     .slots = {{{"iceberg", "an iceberg"}}}},

    // A start, a goal or a via point.
    {.code = "place-on-land",
     .rank = Rank::caution,
     .text = "{place} lies on land in the stored bathymetry or coastline",
     .hint = "Move {place} into the water; longitude comes first",
     .slots = {{{"place", "the goal"}}}},
    {.code = "place-too-shallow",
     .rank = Rank::caution,
     .text = "{place} lies in water shallower than the vehicle's minimum of {least_m:.0f} m",
     .hint = "Move {place} into deeper water, or choose a vehicle for shallower water",
     .slots = {{{"place", "the goal"}, {"least_m", 10.0}}}},
    {.code = "place-in-zone",
     .rank = Rank::caution,
     .text = "{place} lies in a zone that is closed to the vehicle{until}",
     .hint = "Move {place}, change the zone or its times, or depart when the zone is open",
     .slots = {{{"place", "the goal"}, {"until", ", until 2027-01-12T18:00:00Z"}}}},
    {.code = "place-near-iceberg",
     .rank = Rank::caution,
     .text = "{place} lies too close to {iceberg}{until}",
     .hint = "Move {place}, depart at another time, or reduce the margin (--margin) or the position "
             "allowance (--max-inflation)",
     .slots =
         {{{"place", "the goal"}, {"iceberg", "an iceberg"}, {"until", ", until 2027-01-12T18:00:00Z"}}}},
    {.code = "place-outside-data",
     .rank = Rank::caution,
     .text = "{place} lies {where}",
     .hint = "Move {place}, ingest bathymetry that covers it, or plan without depths (--bathymetry none)",
     .slots = {{{"place", "the goal"},
                {"where",
                 "12 km east of the stored bathymetry (area of the data near here: 54° W to 50° W, 68° N to "
                 "70° N)"}}}},
    {.code = "place-outside-depths-and-currents",
     .rank = Rank::caution,
     .text = "{place} lies {where}, and {beside}",
     .hint = "Move {place}, or ingest bathymetry and currents that cover it",
     .slots = {{{"place", "the goal"},
                {"where",
                 "12 km east of the stored bathymetry (area of the data near here: 54° W to 50° W, 68° N to "
                 "70° N)"},
                {"beside",
                 "12 km east of the stored currents (area of the data near here: 54° W to 50° W, 68° N to "
                 "70° N)"}}}},

    // Refusals by a search. {closed} and {help}: text and hint of the row for what closes most edges.
    {.code = "no-way-to-goal",
     .rank = Rank::caution,
     .text = "no route to the goal was found. At the place nearest to the goal that the search "
             "reached, {closed}",
     .hint = "{help}. A smaller grid spacing (--spacing) finds narrower passages",
     .slots = {{{"closed", "the route crosses land"}, {"help", "Lead the route round the land (--via)"}}}},
    {.code = "no-way-in-data",
     .rank = Rank::caution,
     .text = "no route to the goal was found. At the place nearest to the goal that the search reached, "
             "{closed}",
     .hint = "{help}",
     .slots = {{{"closed", "the stored currents end at 2027-01-14T00:00:00Z, before the route ends"},
                {"help", "Ingest a longer forecast, or hold the currents steady (--steady)"}}}},
    {.code = "no-way-through-currents",
     .rank = Rank::caution,
     .text = "no route to the goal was found. At the place nearest to the goal that the search "
             "reached, {closed}",
     .hint = "{help}. A via point (--via) widens the search",
     .slots = {{{"closed", "the current is too strong for 0.35 m/s through the water"},
                {"help", "depart at another time"}}}},
    {.code = "no-way-within-memory",
     .rank = Rank::caution,
     .text = "no route to the goal was found. At the place nearest to the goal that the search "
             "reached, {closed}",
     .hint = "{help}. A larger grid spacing (--spacing) needs less computing work",
     .slots = {{{"closed", "the route crosses land"}, {"help", "Lead the route round the land (--via)"}}}},
    {.code = "never-holds",
     .rank = Rank::note,
     .text = "the vehicle is not allowed to hold, but part of the water reopens later",
     .hint = "Allow holds (--max-hold), or depart later"},
    {.code = "no-escape",
     .rank = Rank::caution,
     .text = "from this waypoint, no escape route of at most 200 grid steps leads to a place where the "
             "vehicle may surface",
     .hint = "Allow surfacing in denser ice (--max-concentration-to-surface), choose a larger grid spacing "
             "(--spacing), or plan without escape routes (leave out --escape-plan)"},
    {.code = "no-escape-in-time",
     .rank = Rank::caution,
     .text = "from this waypoint, no escape route of at most 200 grid steps reaches a place to surface "
             "within the limit of {bound_h:duration} without surfacing",
     .hint = "Allow more time (--max-time-without-surfacing) or surfacing in denser ice "
             "(--max-concentration-to-surface), choose a larger grid spacing (--spacing), or plan without "
             "escape routes (leave out --escape-plan)",
     .slots = {{{"bound_h", 12.0}}}},
    {.code = "earliest-departure-too-late",
     .rank = Rank::caution,
     .text = "even with the earliest departure, {depart}, the vehicle arrives only at {arrival}",
     .hint = "Allow that arrival (--arrive-by) or an earlier departure (--depart), or raise the speed",
     .slots = {{{"depart", "2027-01-12T06:00:00Z"}, {"arrival", "2027-01-13T18:10:00Z"}}}},
    {.code = "earliest-departure-in-too-few-members",
     .rank = Rank::caution,
     .text = "even with the earliest departure, {depart}, the vehicle arrives in time in too few members of "
             "the ensemble of currents",
     .hint = "Allow a later arrival (--arrive-by) or an earlier departure (--depart), or raise the speed",
     .slots = {{{"depart", "2027-01-12T06:00:00Z"}}}},
    {.code = "grid-too-large",
     .rank = Rank::caution,
     .text =
         "the grid would have {vertices_millions:.0f} million vertices, more than the memory limit allows",
     .hint = "Choose a larger grid spacing (--spacing), or plan in parts",
     .slots = {{{"vertices_millions", 120.0}}}},
    {.code = "too-many-icebergs",
     .rank = Rank::caution,
     .text = "the area holds {icebergs} icebergs, more than one plan can forecast",
     .hint = "Plan in parts, or use younger sightings only (--max-sighting-age)",
     .slots = {{{"icebergs", 25000}}}},
    {.code = "cancelled", .rank = Rank::note, .text = "the search was cancelled", .hint = "Start it again"},

    // Further findings. The hint of one of these replaces the hint of the finding that closes the route.
    {.code = "way-without-icebergs",
     .rank = Rank::note,
     .text = "without the icebergs, a route exists",
     .hint = "Depart at another time, or reduce the margin (--margin) or the position allowance "
             "(--max-inflation)"},
    {.code = "way-without-zones",
     .rank = Rank::note,
     .text = "without the zones, a route exists",
     .hint = "Change the zones or their times"},
    {.code = "way-without-ice",
     .rank = Rank::note,
     .text = "without the ice, a route exists",
     .hint = "Dive deeper (--dive-depth), or reduce the clearance below ice (--margin-below-ice)"},
    {.code = "way-without-currents",
     .rank = Rank::note,
     .text = "without the currents, a route exists",
     .hint = "Depart at another time, or raise the speed"},
    {.code = "stop-outside-currents",
     .rank = Rank::note,
     .text = "{place} lies {where}",
     .hint = "Move {place} into the water of the currents, or ingest currents that cover it",
     .slots = {{{"place", "the goal"},
                {"where",
                 "12 km east of the stored currents (area of the data near here: 54° W to 50° W, 68° N to "
                 "70° N)"}}}},
    {.code = "data-end-on-the-way",
     .rank = Rank::note,
     .text = "beyond this place the stored {data} have no values. In this area they cover {area}",
     .hint = "Ingest {data} that cover the whole route, or choose a start and a goal within this area",
     .slots = {{{"data", "currents"}, {"area", "54° W to 50° W, 68° N to 70° N"}}}},
    {.code = "water-ends-on-the-way",
     .rank = Rank::note,
     .text = "beyond this place the stored {data} have no values, because the water of the model ends there",
     .hint = "Ingest {data} that cover the whole route, or lead the route through water of the model (--via)",
     .slots = {{{"data", "currents"}}}},
    {.code = "earlier-departure-possible",
     .rank = Rank::note,
     .text = "the stored currents begin at {begin}, so the vehicle may also depart earlier (--depart)",
     .slots = {{{"begin", "2027-01-11T00:00:00Z"}}}},
    {.code = "nearest-water",
     .rank = Rank::note,
     .text = "the nearest water deep enough for the vehicle lies {distance_km:distance} to the {direction} "
             "of {place}",
     .slots = {{{"distance_km", 12.0}, {"direction", "east"}, {"place", "the goal"}}}},
    {.code = "no-water-near",
     .rank = Rank::note,
     .text = "in the search area, the nearest water deep enough for the vehicle lies more than "
             "{distance_km:distance} from {place}",
     .hint = "Choose a place at sea; longitude comes first",
     .slots = {{{"distance_km", 100.0}, {"place", "the goal"}}}},
    {.code = "search-without-end",
     .rank = Rank::note,
     .text = "the search stopped at its limit of computing work, so a route may still exist",
     .hint = "Choose a larger grid spacing (--spacing), so that the search can finish"},
    {.code = "searched-from-stop-to-stop",
     .rank = Rank::note,
     .text = "the search reaches each via point as early as possible. A route that reaches a via point "
             "later may still exist",
     .hint = "Depart later, or leave out a via point"},
    {.code = "area-searched",
     .rank = Rank::note,
     .text = "the search went up to {beside_km:distance} to either side of the direct line and beyond its "
             "ends",
     .slots = {{{"beside_km", 104.0}}}},
    {.code = "other-orders-tried",
     .rank = Rank::note,
     .text = "this reason is for the via points in the given order. {orders} promising {orders:other "
             "order|other orders} {orders:was|were} tried, too, and gave no plan",
     .slots = {{{"orders", 4}}}},
    {.code = "departures-tried",
     .rank = Rank::note,
     .text = "{tried} of {departures} departures were tried without a plan. {left} {left:other departure "
             "has|other departures have} a route but {left:was|were} not planned in full",
     .hint = "Choose a shorter window, so that all departures are planned",
     .slots = {{{"tried", 24}, {"departures", 31}, {"left", 3}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message refusal(const Given&... given) {
  return make_message<refusal_kinds, code>(given...);
}

/// Phrases that are values of these messages.
inline constexpr auto phrase_kinds = std::to_array<Kind>({
    {.code = "an-iceberg", .rank = Rank::note, .text = "an iceberg"},
    {.code = "iceberg-with-margin",
     .rank = Rank::note,
     .text = "{iceberg} at {time} (keep-out distance: hull + {margin_m:distance} margin)",
     .slots = {{{"iceberg", "iceberg B-17"}, {"time", "2027-01-12T12:00:00Z"}, {"margin_m", 500.0}}}},
    {.code = "iceberg-with-margin-and-error",
     .rank = Rank::note,
     .text = "{iceberg} at {time} (keep-out distance: hull + {margin_m:distance} margin + {error_m:distance} "
             "position error)",
     .slots = {{{"iceberg", "iceberg B-17"},
                {"time", "2027-01-12T12:00:00Z"},
                {"margin_m", 500.0},
                {"error_m", 3000.0}}}},
    {.code = "until",
     .rank = Rank::note,
     .text = ", until {time}",
     .slots = {{{"time", "2027-01-12T18:00:00Z"}}}},
    {.code = "for-good", .rank = Rank::note, .text = ", for the whole forecast"},
    {.code = "outside-of-data",
     .rank = Rank::note,
     .text = "{distance_km:distance} {direction} of the stored {data} (area of the data near here: {area})",
     .slots = {{{"distance_km", 12.0},
                {"direction", "east"},
                {"data", "bathymetry"},
                {"area", "54° W to 50° W, 68° N to 70° N"}}}},
    {.code = "away-from-water-of-data",
     .rank = Rank::note,
     .text = "{distance_km:distance} {direction} of the nearest water of the stored {data}, which is at "
             "{lon_deg:.4f}, {lat_deg:.4f}",
     .slots = {{{"distance_km", 12.0},
                {"direction", "east"},
                {"data", "currents"},
                {"lon_deg", -53.2},
                {"lat_deg", 69.2}}}},
    {.code = "where-data-have-no-water",
     .rank = Rank::note,
     .text = "where the stored {data} have no water: there is none from {area}",
     .slots = {{{"data", "currents"}, {"area", "54° W to 50° W, 68° N to 70° N"}}}},
    {.code = "in-gap-of-data",
     .rank = Rank::note,
     .text = "in a gap of the stored {data} (area of the data near here: {area})",
     .slots = {{{"data", "bathymetry"}, {"area", "54° W to 50° W, 68° N to 70° N"}}}},
});

template <Code code, class... Given>
[[nodiscard]] std::string phrase(const Given&... given) {
  return make_message<phrase_kinds, code>(given...).text;
}

}  // namespace floeplan::messages
