#pragma once

#include <string>
#include <utility>

#include "engine/messages/kind.hpp"
#include "engine/messages/sentence.hpp"

/// Why mission files, a plan or a glider's log cannot be flown in the simulator. Each text follows the name
/// of the field, file or column. They have no rank: what is refused endangers no vehicle.
namespace floeplan::messages {

inline constexpr auto flight_fault_kinds = std::to_array<Kind>({
    // The files.
    {.code = "no-mission-and-no-list", .text = "must hold a mission (.mi) or a goto list (.ma)"},
    {.code = "no-list-to-fly", .text = "must hold a goto list with at least one waypoint"},
    {.code = "no-yo-to-fly", .text = "must hold a yo, because only a yo commands pitch and buoyancy"},
    {.code = "several-missions",
     .text = "must hold only one mission (.mi), not {missions}",
     .hint = "give one of them",
     .slots = {{{"missions", 2}}}},
    {.code = "file-of-seaglider",
     .text = "is a file of a Seaglider, but this vehicle ({vehicle}) reads .mi and .ma files",
     .hint = "choose a Seaglider as the vehicle, or give .mi and .ma files",
     .slots = {{{"vehicle", "Slocum G3, 200 m"}}}},
    {.code = "mission-line-refused",
     .text = "line {line}: {finding}",
     .slots = {{{"line", 12},
                {"finding", "this b_arg stands before the first behavior, so it belongs to none"}}}},
    {.code = "file-asked-for-missing",
     .text = "asks in line {line} for {file}, which is missing; give this file too",
     .slots = {{{"file", "goto_l10.ma"}, {"line", 12}}}},

    // The yo and its surfacings.
    {.code = "depth-of-another-program",
     .text = "stands for a depth that another program on board sets; give the depth itself"},
    {.code = "deeper-than-rating",
     .text = "is {depth} m, deeper than the rating of {vehicle} ({rating} m)",
     .hint = "choose the vehicle for which the files were written, or dive less deep",
     .slots = {{{"depth", "980"}, {"vehicle", "Slocum G3, 200 m"}, {"rating", "200"}}}},
    {.code = "wrong-pitch", .text = "must be an angle in radians between -1.57 and 1.57"},
    {.code = "yo-without-thruster",
     .text = "needs a thruster, but {vehicle} has none",
     .hint = "choose a vehicle with a thruster, or take the thruster out of the yo",
     .slots = {{{"vehicle", "Slocum G3, 200 m"}}}},
    {.code = "climb-below-dive", .text = "must be shallower than d_target_depth"},
    {.code = "surfacings-too-often", .text = "must be 120 s or more"},

    // The start and the data.
    {.code = "wrong-start", .text = "must be a longitude and a latitude in degrees"},
    {.code = "start-outside-data",
     .text = "lies outside the stored bathymetry and currents at the departure; move it, or ingest data that "
             "cover it"},
    {.code = "row-outside-data",
     .text = "lies outside the stored bathymetry and currents; move it, or ingest data that cover it"},
    {.code = "start-on-land", .text = "lies on land; move it into the water"},
    {.code = "launch-under-ice",
     .text = "lies under ice at the departure, but the simulator launches a vehicle at the surface; plan "
             "again from a start in open water"},
    {.code = "currents-end-in-flight",
     .text = "is too late, because the currents end before the vehicle can reach its last waypoint even at "
             "twice its speed; ingest currents of a longer time"},
    {.code = "plan-for-another-vehicle",
     .text = "is {vehicle}, but the plan {plan} is for {planned}; plan again for this vehicle, or leave the "
             "vehicle out",
     .slots = {{{"vehicle", "slocum-g3-1000"}, {"plan", "p0123456789ab"}, {"planned", "slocum-g3-200"}}}},
    {.code = "sonar-does-not-suit",
     .text = "does not suit the obstacle avoidance: its {setting} {rule}; change it, or fly without obstacle "
             "avoidance (\"avoidance\": false)",
     .slots = {{{"setting", "range_m"}, {"rule", "must be between 1 m and 1000 m"}}}},

    // Logs.
    {.code = "log-too-large", .text = "is larger than 256 MiB; give fewer segments of the log"},
    {.code = "log-without-names",
     .text = "must begin with a line of sensor names between commas; convert the vehicle's binary log to "
             "such text first"},
    {.code = "more-fields-than-names",
     .text = "has more fields than the first line has names; convert the log again"},
    {.code = "log-not-a-number",
     .text = "must be a number or empty, not {found}",
     .slots = {{{"found", "n/a"}}}},
    {.code = "column-missing",
     .text = "is missing, but the log must have this column",
     .hint = "convert the log again with it"},
    {.code = "column-of-currents-missing",
     .text = "is missing, but the log must have this column or m_final_water_vx",
     .hint = "convert the log again with one of them"},
    {.code = "column-of-pump-missing",
     .text = "is missing, but the log must have this column or m_de_oil_vol and move",
     .hint = "convert the log again with these columns"},
    {.code = "axes-of-currents-unknown",
     .text = "is missing, but the log must have this column or x_utm_to_lmc_00 and _01. They give the "
             "direction of the vehicle's own axes, in which the currents are logged. The World Magnetic "
             "Model gives it only from 2010 to 2030",
     .hint = "Convert the log again with these columns"},
    {.code = "no-dive-in-log",
     .text = "shows no dive that can be compared. Such a dive has a position before and after it, a "
             "waypoint, a current and two turns at depth; give the log of a flight with such dives"},
    {.code = "did-not-come-up",
     .text = "did not surface in the simulation: {why}",
     .slots = {{{"why", "the battery is empty"}}}},
    {.code = "units-of-positions-differ",
     .text = "and {other} have different units, so their notations differ; write the same unit above both",
     .slots = {{{"other", "m_lon"}}}},
    {.code = "positions-not-in-degrees",
     .text = "and {other} have the unit degrees but hold {found}, which is in degrees and minutes; correct "
             "the unit",
     .slots = {{{"other", "m_lon"}, {"found", "6912.5"}}}},
    {.code = "positions-not-in-minutes",
     .text = "and {other} have the unit degrees and minutes but hold {found}, which is in decimal degrees; "
             "correct the unit",
     .slots = {{{"other", "m_lon"}, {"found", "69.75"}}}},
    {.code = "positions-of-two-notations",
     .text = "and {other} hold both degrees and minutes ({packed}) and decimal degrees ({decimal}); convert "
             "the log again, in one notation",
     .slots = {{{"other", "m_lon"}, {"packed", "6912.5"}, {"decimal", "69.75"}}}},
    {.code = "positions-undecided",
     .text = "and {other} may be degrees and minutes or decimal degrees, so the first position is {packed} "
             "or {decimal}. Write the unit ddmm or deg above both, or convert the log with m_x_lmc, m_y_lmc, "
             "m_lat and m_lon",
     .slots = {{{"other", "m_lon"}, {"packed", "0.5 N 0.4 E"}, {"decimal", "30.0 N 24.0 E"}}}},
});

/// The violation of a field of a simulated flight, a mission file or a log, with the text of this row.
template <Code code, class... Given>
[[nodiscard]] core::Violation flight_fault(std::string field, const Given&... values) {
  return violation_of(std::move(field), make_message<flight_fault_kinds, code>(values...));
}

}  // namespace floeplan::messages
