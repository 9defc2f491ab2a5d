#pragma once

#include <string>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Messages to the pilot about a simulated flight: orders in the files that are not simulated, and why the
/// flight ended.
/// Ranks    all are notes: nothing was flown at sea
namespace floeplan::messages {

inline constexpr auto flight_kinds = std::to_array<Kind>({
    // Differences between the simulator and the vehicle.
    {.code = "sampling-not-simulated",
     .rank = Rank::note,
     .text = "the simulator does not switch sensors on and off. Their energy is that of the vehicle "
             "profile"},
    {.code = "behavior-not-simulated",
     .rank = Rank::note,
     .text = "the simulator ignores the behavior {behavior} of {file}",
     .hint = "The true vehicle may fly differently from this point on",
     .slots = {{{"behavior", "set_heading"}, {"file", "floe.mi"}}}},
    {.code = "surfacing-not-simulated",
     .rank = Rank::note,
     .text = "the simulator ignores the surfacing with start_when {when} in {file}. The true vehicle may "
             "surface there",
     .slots = {{{"when", 14}, {"file", "surfac10.ma"}}}},
    {.code = "second-yo-not-simulated",
     .rank = Rank::note,
     .text = "the simulator flies only one yo and ignores the second. The depths of the true vehicle may "
             "be different"},
    {.code = "list-sent-near-end-of-hold",
     .rank = Rank::note,
     .text =
         "while the vehicle holds, the next list is sent at the surfacing nearest to the end of the hold"},
    {.code = "pitch-without-calibration",
     .rank = Rank::note,
     .text = "the files order the pitch by the position of the battery, which only the calibration of "
             "the vehicle turns into an angle. The simulator uses {pitch} degrees",
     .slots = {{{"pitch", "26"}}}},
    {.code = "yo-of-the-vehicle",
     .rank = Rank::note,
     .text = "the files hold no yo, so the simulator uses the depths, pitch and pump of the vehicle "
             "profile"},
    {.code = "surfacing-at-the-end",
     .rank = Rank::note,
     .text = "the files hold no surfacing, so the vehicle surfaces only at the end of its list"},
    {.code = "positions-taken-for-decimal",
     .rank = Rank::note,
     .text = "the positions ({names}) were read as decimal degrees, not as a Slocum's degrees and "
             "minutes: {why}",
     .hint = "Check the track on the map, and write the unit deg above these columns",
     .slots = {{{"names", "m_gps_lat, m_gps_lon"}, {"why", "their minutes would be 60 and more"}}}},

    // Why the flight ended.
    {.code = "flight-arrived", .rank = Rank::note, .text = "the vehicle reached the last waypoint"},
    {.code = "flight-ended-by-surfacing",
     .rank = Rank::note,
     .text = "a surfacing ended the mission before the last waypoint"},
    {.code = "flight-battery-empty",
     .rank = Rank::note,
     .text = "the battery was used down to its reserve before the last waypoint",
     .hint = "Start with a fuller battery, or plan a shorter route"},
    {.code = "flight-too-long",
     .rank = Rank::note,
     .text = "the flight took longer than the longest allowed flight",
     .hint = "Check whether the current holds the vehicle back, or allow a longer flight"},
    {.code = "flight-left-currents",
     .rank = Rank::note,
     .text = "the vehicle came to a place or a time without stored currents, so the flight ended",
     .hint = "Ingest currents that cover a wider area and a longer time"},
    {.code = "flight-stopped", .rank = Rank::note, .text = "the flight was stopped on request"},
    {.code = "aborted-too-deep",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because it was deeper than abend allows",
     .hint = "Dive less deep, or check the overdepth of abend"},
    {.code = "aborted-by-avoidance",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because the onboard avoidance gave up: {why}",
     .hint = "Lead the route farther from obstacles",
     .slots = {{{"why", "no progress"}}}},
    {.code = "aborted-at-one-depth",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because it stayed at one depth for longer than "
             "samedepth_for of abend. The sea bed, ice or the onboard avoidance left no room for dives",
     .hint = "Lead the route through deeper water"},
    {.code = "aborted-far-waypoint",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because the next waypoint lay beyond max_wpt_distance of "
             "abend",
     .hint = "Divide the leg, or raise max_wpt_distance"},
    {.code = "aborted-without-heading",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because its list had ended and nothing else ordered a "
             "heading",
     .hint = "Add a behavior that orders a heading, or a surfacing at the end"},
    {.code = "aborted-without-pitch",
     .rank = Rank::note,
     .text = "the vehicle aborted the mission, because its yo had ended and nothing else ordered a pitch",
     .hint = "Add a yo, or a surfacing at the end"},
    {.code = "turned-back-below-ice",
     .rank = Rank::note,
     .text = "the vehicle could not surface because of ice above it, so it went back to the place where "
             "it had last surfaced"},
});

/// The message of this code as one sentence; its values are given in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] std::string flight_text(const Given&... given) {
  return whole_text(make_message<flight_kinds, code>(given...));
}

}  // namespace floeplan::messages
