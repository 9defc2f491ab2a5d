#pragma once

#include <string>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// What a pilot is told of a simulated flight: what is not simulated as the files ask for it, and why the flight ended.
/// Ranks    all are notes: nothing was flown at sea
namespace floeplan::messages {

inline constexpr auto flight_kinds = std::to_array<Kind>({
    // What the simulator does otherwise than the vehicle.
    {.code = "sampling-not-simulated",
     .rank = Rank::note,
     .text = "When sensors sample is not simulated; their energy is that of the vehicle profile."},
    {.code = "behavior-not-simulated",
     .rank = Rank::note,
     .text = "Behavior {behavior} of {file} is not simulated.",
     .slots = {{{"behavior", "set_heading"}, {"file", "floe.mi"}}}},
    {.code = "surfacing-not-simulated",
     .rank = Rank::note,
     .text = "A surfacing with start_when {when} in {file} is not simulated.",
     .slots = {{{"when", 14}, {"file", "surfac10.ma"}}}},
    {.code = "second-yo-not-simulated", .rank = Rank::note, .text = "A second yo is not simulated."},
    {.code = "list-sent-near-end-of-hold",
     .rank = Rank::note,
     .text =
         "While the vehicle holds, the next list is sent at the surfacing nearest to the end of the hold."},
    {.code = "pitch-without-calibration",
     .rank = Rank::note,
     .text =
         "Pitch by battery position needs the vehicle's calibration; the simulator takes {pitch} degrees.",
     .slots = {{{"pitch", "26"}}}},
    {.code = "yo-of-the-vehicle",
     .rank = Rank::note,
     .text = "The files hold no yo; the simulator takes the vehicle's own depths, pitch and pump."},
    {.code = "surfacing-at-the-end",
     .rank = Rank::note,
     .text = "The files hold no surfacing; the vehicle surfaces at the end of its list."},
    {.code = "positions-taken-for-decimal",
     .rank = Rank::note,
     .text =
         "the positions ({names}) were read as decimal degrees, not as a Slocum's degrees and minutes: {why}",
     .hint = "see where the track lies, and write the unit deg above them",
     .slots = {{{"names", "m_gps_lat, m_gps_lon"}, {"why", "their minutes would be 60 and more"}}}},

    // Why the flight ended.
    {.code = "flight-arrived", .rank = Rank::note, .text = "The last waypoint was reached."},
    {.code = "flight-ended-by-surfacing",
     .rank = Rank::note,
     .text = "A surfacing ended the mission before its last waypoint."},
    {.code = "flight-battery-empty", .rank = Rank::note, .text = "The battery is down to its reserve."},
    {.code = "flight-too-long",
     .rank = Rank::note,
     .text = "The flight took longer than the settings allow."},
    {.code = "flight-left-currents",
     .rank = Rank::note,
     .text = "The currents are not known where and when the vehicle is."},
    {.code = "flight-stopped", .rank = Rank::note, .text = "The flight was stopped on request."},
    {.code = "aborted-too-deep",
     .rank = Rank::note,
     .text = "The mission was aborted below the depth that abend allows."},
    {.code = "aborted-by-avoidance",
     .rank = Rank::note,
     .text = "The mission was aborted: the onboard avoidance gave up: {why}.",
     .slots = {{{"why", "no progress"}}}},
    {.code = "aborted-at-one-depth",
     .rank = Rank::note,
     .text = "The mission was aborted: samedepth_for of abend is over; sea bed, ice or the onboard avoidance "
             "leave "
             "no room for dives."},
    {.code = "aborted-far-waypoint",
     .rank = Rank::note,
     .text = "The mission was aborted: the next waypoint lies beyond max_wpt_distance of abend."},
    {.code = "aborted-without-heading",
     .rank = Rank::note,
     .text = "The list is flown, and nothing else gives a heading."},
    {.code = "aborted-without-pitch",
     .rank = Rank::note,
     .text = "The yo has ended, and nothing else gives a pitch."},
    {.code = "turned-back-below-ice",
     .rank = Rank::note,
     .text = "Ice lay above; the vehicle went back to where it had last been at the surface."},
});

/// The message of this code as one sentence; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] std::string flight_text(const Given&... given) {
  return whole_text(make_message<flight_kinds, code>(given...));
}

}  // namespace floeplan::messages
