#pragma once

#include <string>
#include <utility>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Why mission files, a plan or the log of a glider cannot be flown in the simulator. Each text follows the name of the
/// field, file or column. None has a rank of its own: what is refused endangers nobody.
namespace floeplan::messages {

inline constexpr auto flight_fault_kinds = std::to_array<Kind>({
    // The files.
    {.code = "no-mission-and-no-list", .text = "must hold a mission or a goto list"},
    {.code = "no-list-to-fly", .text = "must hold a goto list with a waypoint"},
    {.code = "no-yo-to-fly", .text = "must hold a yo: nothing else commands pitch and buoyancy"},
    {.code = "several-missions",
     .text = "must hold one mission (.mi), not {missions}",
     .slots = {{{"missions", 2}}}},
    {.code = "file-of-seaglider",
     .text = "is a file of a Seaglider; this vehicle ({vehicle}) reads .mi and .ma files",
     .slots = {{{"vehicle", "Slocum G3, 200 m"}}}},
    {.code = "mission-line-refused",
     .text = "line {line}: {finding}",
     .slots = {{{"line", 12}, {"finding", "a b_arg before the first behavior"}}}},
    {.code = "file-asked-for-missing",
     .text = "asks for {file} in line {line}, which is not among the files",
     .slots = {{{"file", "goto_l10.ma"}, {"line", 12}}}},

    // The yo and its surfacings.
    {.code = "depth-of-another-program",
     .text =
         "stands for a parameter that another program on board sets; the simulator needs the depth itself"},
    {.code = "deeper-than-rating",
     .text = "is {depth} m, below the rating of {vehicle} ({rating} m): the files are for another vehicle",
     .slots = {{{"depth", "980"}, {"vehicle", "Slocum G3, 200 m"}, {"rating", "200"}}}},
    {.code = "wrong-pitch", .text = "must be an angle in radians between -1.57 and 1.57"},
    {.code = "yo-without-thruster",
     .text = "needs a thruster, and {vehicle} has none",
     .slots = {{{"vehicle", "Slocum G3, 200 m"}}}},
    {.code = "climb-below-dive", .text = "must be above d_target_depth"},
    {.code = "surfacings-too-often", .text = "must be 120 s or more"},

    // The start and the data.
    {.code = "wrong-start", .text = "must be a longitude and a latitude"},
    {.code = "start-outside-data",
     .text = "lies outside the data of sea bed and currents at the departure; move it, or ingest data that "
             "cover it"},
    {.code = "row-outside-data",
     .text = "lies outside the data of sea bed and currents; move it, or ingest data that cover it"},
    {.code = "start-on-land", .text = "lies on land"},
    {.code = "launch-under-ice",
     .text = "lies under ice at the departure, but the simulator launches a vehicle at the surface: plan "
             "again from a start in open water"},
    {.code = "currents-end-in-flight",
     .text =
         "is too late: the currents end before the vehicle can be at its last waypoint, even at twice its "
         "speed; use data that reach further"},
    {.code = "plan-for-another-vehicle",
     .text = "is {vehicle}, but the plan {plan} is for {planned}; plan again for the vehicle that is to fly, "
             "or leave the vehicle out",
     .slots = {{{"vehicle", "slocum-g3-1000"}, {"plan", "p0123456789ab"}, {"planned", "slocum-g3-200"}}}},
    {.code = "sonar-does-not-suit",
     .text = "does not suit the obstacle avoidance system: its {setting} {rule}; or fly without it, with "
             "avoidance false",
     .slots = {{{"setting", "range_m"}, {"rule", "must be between 1 m and 1000 m"}}}},

    // Logs.
    {.code = "log-too-large", .text = "is larger than 256 MiB; cut it by segments"},
    {.code = "log-without-names",
     .text = "must begin with a line of sensor names between commas; turn a vehicle's binary log into such "
             "text first"},
    {.code = "more-fields-than-names", .text = "has more fields than the line of names"},
    {.code = "log-not-a-number",
     .text = "must be a number or empty, not {found}",
     .slots = {{{"found", "n/a"}}}},
    {.code = "column-missing", .text = "is a column that the log must have"},
    {.code = "column-of-currents-missing", .text = "is a column that the log must have, or m_final_water_vx"},
    {.code = "column-of-pump-missing",
     .text = "is a column that the log must have, or m_de_oil_vol, and move"},
    {.code = "axes-of-currents-unknown",
     .text = "is a column that the log must have, or x_utm_to_lmc_00 and _01: its currents are in the "
             "vehicle's own axes, and the World Magnetic Model tells these from 2010 to 2030 alone"},
    {.code = "no-dive-in-log",
     .text = "shows no dive that can be compared: each needs a position before and after it, a waypoint, a "
             "current and "
             "two turns at depth; give the log of a flight that has them"},
    {.code = "did-not-come-up",
     .text = "did not come up when it was simulated: {why}",
     .slots = {{{"why", "the battery is empty"}}}},
    {.code = "units-of-positions-differ",
     .text = "and {other} state different notations by their units; write the same unit above both",
     .slots = {{{"other", "m_lon"}}}},
    {.code = "positions-not-in-degrees",
     .text = "and {other} are in degrees by their unit, but hold {found}, which is degrees and minutes; "
             "correct the unit",
     .slots = {{{"other", "m_lon"}, {"found", "6912.5"}}}},
    {.code = "positions-not-in-minutes",
     .text = "and {other} are in degrees and minutes by their unit, but hold {found}, which is decimal "
             "degrees; correct the unit",
     .slots = {{{"other", "m_lon"}, {"found", "69.75"}}}},
    {.code = "positions-of-two-notations",
     .text = "and {other} hold both degrees and minutes ({packed}) and decimal degrees ({decimal}); convert "
             "the log again, in one notation",
     .slots = {{{"other", "m_lon"}, {"packed", "6912.5"}, {"decimal", "69.75"}}}},
    {.code = "positions-undecided",
     .text = "and {other} could be degrees and minutes or decimal degrees, and nothing in the log tells "
             "which: the first position would be {packed} or {decimal}; write the unit ddmm or deg above "
             "both, or convert the log with m_x_lmc, m_y_lmc, m_lat and m_lon",
     .slots = {{{"other", "m_lon"}, {"packed", "0.5 N 0.4 E"}, {"decimal", "30.0 N 24.0 E"}}}},
});

/// What a row says of a field of a simulated flight, of a mission file or of a log.
template <Code code, class... Given>
[[nodiscard]] core::Violation flight_fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<flight_fault_kinds, code>(values...));
}

}  // namespace floeplan::messages
