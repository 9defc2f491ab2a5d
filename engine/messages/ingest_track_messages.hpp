#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about a glider's track and logs.
namespace floeplan::messages {

inline constexpr auto ingest_track_kinds = std::to_array<Kind>({
    // Tracks.
    {.code = "track-without-places",
     .rank = Rank::caution,
     .text = "the file holds no position of the glider with its time, so nothing was stored",
     .hint = "Give a file with fixes"},
    {.code = "track-positions-left-out",
     .rank = Rank::note,
     .text = "{positions} {positions:position was|positions were} left out, because {positions:it is|they "
             "are} not on the globe or exactly 0 N 0 E",
     .slots = {{{"positions", 3}}}},
    {.code = "track-depths-left-out",
     .rank = Rank::note,
     .text = "{depths} {depths:depth was|depths were} left out, because {depths:it is|they are} not between "
             "-20 and 12000 m",
     .slots = {{{"depths", 3}}}},
    {.code = "track-put-in-order",
     .rank = Rank::note,
     .text = "the times did not always rise, so the rows were sorted by time"},
    {.code = "zero-currents-left-out",
     .rank = Rank::note,
     .text = "{currents} {currents:depth-averaged current was|depth-averaged currents were} left out, "
             "because {currents:it is|they are} exactly 0. A glider writes 0 if it does not know the current",
     .slots = {{{"currents", 3}}}},
    {.code = "impossible-currents-left-out",
     .rank = Rank::note,
     .text = "{currents} {currents:depth-averaged current was|depth-averaged currents were} left out, "
             "because {currents:it is|they are} over 10 m/s or not on the globe",
     .slots = {{{"currents", 3}}}},
    {.code = "track-too-fast",
     .rank = Rank::caution,
     .text = "between {pairs} {pairs:pair|pairs} of fixes the speed over ground exceeds 10 m/s (at most "
             "{fastest} m/s, at {moment}). A position or a time is wrong there",
     .hint = "Check the fixes",
     .slots = {{{"pairs", 2}, {"fastest", "35.2"}, {"moment", "2026-11-20T06:00:00Z"}}}},
    {.code = "track-thinned",
     .rank = Rank::note,
     .text = "one in {stride} of the {rows} rows was kept, because a track has at most a million points",
     .slots = {{{"rows", 2500000}, {"stride", 4}}}},
    {.code = "currents-taken-as-true-north",
     .rank = Rank::caution,
     .text = "the depth-averaged currents were read as true east and north, as the file states them. Not "
             "every producer turns them from the vehicle's own axes",
     .hint = "Ask the producer if they look turned"},
    {.code = "reckoned-positions-left-out",
     .rank = Rank::note,
     .text = "{positions} {positions:position was|positions were} left out. The vehicle computed "
             "{positions:it|them} by dead reckoning before its first fix, and {positions:it is|they are} too "
             "far from this fix",
     .slots = {{{"positions", 3}}}},
    {.code = "currents-turned-to-true-north",
     .rank = Rank::note,
     .text = "the depth-averaged currents were turned from the vehicle's own axes to true east and north: "
             "{how}",
     .slots = {{{"how", "by the vehicle's own magnetic variation of -28.4 degrees"}}}},
    {.code = "axes-doubtful",
     .rank = Rank::caution,
     .text = "{doubt}",
     .slots = {{{"doubt", "the magnetic variation of the log differs from the model's"}}}},
    {.code = "currents-in-vehicle-axes-left-out",
     .rank = Rank::caution,
     .text = "{currents} {currents:depth-averaged current was|depth-averaged currents were} left out, "
             "because {currents:it is|they are} in the vehicle's own axes, whose direction is not known. The "
             "log has no usable x_utm_to_lmc_00 and _01 or m_gps_mag_var, and the World Magnetic Model "
             "covers only 2010 to 2030",
     .hint = "Convert the log with m_gps_mag_var",
     .slots = {{{"currents", 3}}}},
    {.code = "currents-with-one-component",
     .rank = Rank::caution,
     .text = "the currents \"{first}\" and \"{second}\" were left out, because both say that they are the "
             "same component. A wrong guess would turn them",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "currents-not-of-dives",
     .rank = Rank::note,
     .text = "the currents \"{first}\" and \"{second}\" change from row to row, so they are not averages of "
             "dives and were left out",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "currents-of-vehicle-axes",
     .rank = Rank::caution,
     .text = "\"{variable}\" comes from {source}, as it says, which a Slocum logs in its own axes",
     .hint = "If its producer did not turn it to east and north, give the vehicle's own log instead",
     .slots = {{{"variable", "u"}, {"source", "m_final_water_vx"}}}},
    {.code = "track-currents-without-time",
     .rank = Rank::note,
     .text = "depth-averaged currents without a time were left out"},
    {.code = "currents-without-unit",
     .rank = Rank::note,
     .text = "the depth-averaged current \"{variable}\" states no unit, so it may be m/s or cm/s. The "
             "currents were left out",
     .slots = {{{"variable", "u"}}}},
    {.code = "currents-with-unknown-unit",
     .rank = Rank::note,
     .text = "the depth-averaged current \"{variable}\" has the unit \"{unit}\", which is not a known speed. "
             "The currents were left out",
     .slots = {{{"variable", "u"}, {"unit", "furlong"}}}},
    {.code = "track-depth-without-unit",
     .rank = Rank::note,
     .text = "the depth \"{variable}\" states no known unit of length and was left out",
     .slots = {{{"variable", "depth"}}}},
    {.code = "track-pressure-without-unit",
     .rank = Rank::note,
     .text = "the pressure \"{variable}\" states no known unit of pressure and was left out",
     .slots = {{{"variable", "pressure"}}}},
    {.code = "currents-on-several-dimensions",
     .rank = Rank::caution,
     .text = "the depth-averaged current \"{variable}\" has values along several dimensions, but a glider "
             "has only one value for each dive",
     .hint = "Give the files of a single glider",
     .slots = {{{"variable", "u"}}}},
    {.code = "track-without-rows",
     .rank = Rank::caution,
     .text = "the file is a glider's, but its time, latitude and longitude do not lie along one dimension",
     .hint = "Give a file with one row for each measurement of one glider"},
    {.code = "several-gliders",
     .rank = Rank::caution,
     .text = "the file holds the tracks of several gliders, and it is not known which rows belong to which "
             "glider",
     .hint = "Ask the producer for a file for each glider"},
    {.code = "log-without-sensors",
     .rank = Rank::caution,
     .text = "the log \"{log}\" has no {sensors}, and a track needs time and position",
     .hint = "Convert the log again with these sensors",
     .slots = {{{"log", "unit-2026-001.dbd.nc"}, {"sensors", "m_present_time"}}}},
    // Seagliders.
    {.code = "seaglider-head-incomplete",
     .rank = Rank::caution,
     .text = "the first lines of the Seaglider's file do not state the glider, the dive and the time at "
             "which the dive began. The file is damaged or was cut short",
     .hint = "Copy it from the basestation again"},
    {.code = "seaglider-columns-missing",
     .rank = Rank::caution,
     .text = "the engineering record has no columns elaps_t and depth with their rows. It is damaged or was "
             "cut short",
     .hint = "Copy it from the basestation again"},
    {.code = "seaglider-record-alone",
     .rank = Rank::caution,
     .text = "an engineering record of a Seaglider holds depths, but no positions",
     .hint = "Give it together with the log of the same dive (.log), or give the NetCDF file of the dive"},
    {.code = "seaglider-log-too-long",
     .rank = Rank::caution,
     .text =
         "a file of a Seaglider's dive is longer than 50 MB, longer than any dive writes, so it is damaged",
     .hint = "Copy it from the basestation again"},
    {.code = "seaglider-current-of-log",
     .rank = Rank::note,
     .text = "the current of a dive is the vehicle's own estimate ($CURRENT in its log), as the direction "
             "towards which it flows from true north. The NetCDF file of the dive has the better estimate of "
             "the basestation"},
    {.code = "seaglider-current-bad",
     .rank = Rank::note,
     .text = "the depth-averaged current of a dive was left out, because the basestation calls it bad or "
             "missing (depth_avg_curr_qc)"},
    {.code = "seaglider-flags-unreadable",
     .rank = Rank::caution,
     .text = "the depth-averaged current of a dive was left out. Its quality (depth_avg_curr_qc) can be read "
             "only in NetCDF-4",
     .hint = "Convert the file to NetCDF-4, for example with nccopy -4"},
    {.code = "seaglider-reckoned-places-bad",
     .rank = Rank::note,
     .text = "the positions of a dive by dead reckoning were left out, because their quality (latlong_qc) is "
             "bad, missing or unreadable. The dive is known only by its fixes"},
    // Logs of Slocum gliders.
    {.code = "log-unreadable",
     .rank = Rank::caution,
     .text = "the log cannot be read, because {where} {fault}",
     .hint = "Copy or convert it again",
     .slots = {{{"where", "line 12"}, {"fault", "must have a number for each sensor"}}}},
    {.code = "log-position-unreadable",
     .rank = Rank::caution,
     .text = "the positions in the log cannot be read, because {where} {fault}",
     .hint = "Copy or convert it again",
     .slots = {{{"where", "m_lat"}, {"fault", "must be degrees and minutes, as 6912.345"}}}},
    {.code = "log-positions-settled",
     .rank = Rank::note,
     .text = "{how}",
     .slots = {{{"how", "m_lat and m_lon were read as decimal degrees"}}}},
    {.code = "log-too-long",
     .rank = Rank::caution,
     .text = "the log is longer than 128 MB, the most that this program reads",
     .hint = "Convert it segment by segment and give the parts together"},
    {.code = "log-row-left-out",
     .rank = Rank::note,
     .text = "the last line has no line end and was left out",
     .hint = "If the log was cut short, copy it again"},
    {.code = "log-without-present-time",
     .rank = Rank::caution,
     .text = "the log has no m_present_time, so its times are not known",
     .hint = "Convert the log again with this sensor"},
    {.code = "log-with-too-many-rows",
     .rank = Rank::caution,
     .text = "the log has more than 2 million rows, the most that this program reads",
     .hint = "Convert it segment by segment and give the parts together"},
    {.code = "binary-log-too-long",
     .rank = Rank::caution,
     .text = "the binary log is longer than 200 MB, more than any glider writes",
     .hint = "Give the segments one by one"},
    {.code = "binary-log-unpacks-to-too-much",
     .rank = Rank::caution,
     .text = "the binary log unpacks to more than 200 MB, more than any glider writes, so it is damaged",
     .hint = "Copy it from the glider again"},
    {.code = "binary-log-damaged",
     .rank = Rank::caution,
     .text = "the binary log is damaged ({fault})",
     .hint = "Copy it from the glider again",
     .slots = {{{"fault", "its tags end early"}}}},
    {.code = "binary-log-without-end",
     .rank = Rank::note,
     .text = "the log ends before its end mark. Its complete part was read",
     .hint = "If it was cut short, copy it again"},
    {.code = "sensor-unit-altered",
     .rank = Rank::caution,
     .text = "the binary log gives {sensor} in \"{stated}\", but all Slocums give it in \"{known}\". The "
             "log's list of sensors is damaged or altered",
     .hint = "Give the glider's own list of sensors",
     .slots = {{{"sensor", "m_depth"}, {"stated", "ft"}, {"known", "m"}}}},
    {.code = "sensor-list-of-another-log",
     .rank = Rank::caution,
     .text = "the list of sensors has {listed} sensors, but the binary log has {wanted}, so the list belongs "
             "to another log",
     .hint = "Give the list that the log names",
     .slots = {{{"listed", 1200}, {"wanted", 1208}}}},
    {.code = "sensor-list-missing",
     .rank = Rank::caution,
     .text = "the binary log does not list its sensors itself. Their list is the file {file}, which the "
             "glider keeps in state/cache",
     .hint = "Give it together with the log",
     .slots = {{{"file", "d0ba8a7e.cac"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_track_message(const Given&... given) {
  return make_message<ingest_track_kinds, code>(given...);
}

}  // namespace floeplan::messages
