#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the axes, grids and quality flags of a NetCDF file.
namespace floeplan::messages {

inline constexpr auto ingest_netcdf_kinds = std::to_array<Kind>({
    // NetCDF: means and axes.
    {.code = "means-out-of-order",
     .rank = Rank::caution,
     .text = "the intervals \"{bounds}\" of the means are not in the order of their times (\"{axis}\"), so "
             "it is not known for when the means hold",
     .hint = "Ask the producer",
     .slots = {{{"bounds", "time_bnds"}, {"axis", "time"}}}},
    {.code = "means-placed-in-the-middle",
     .rank = Rank::note,
     .text = "\"{variable}\" holds means over intervals (\"{bounds}\"). Each mean counts for the middle of "
             "its interval, not for the time that the file states",
     .slots = {{{"variable", "uo"}, {"bounds", "time_bnds"}}}},
    {.code = "netcdf-header-damaged",
     .rank = Rank::caution,
     .text = "the NetCDF header is damaged ({fault}), because the file was cut short or changed",
     .hint = "Copy or download it again",
     .slots = {{{"fault", "a list is damaged"}}}},
    {.code = "axis-empty",
     .rank = Rank::caution,
     .text = "{axis} is empty, so the file holds no data",
     .hint = "Ask the producer for another file",
     .slots = {{{"axis", "the coordinate \"lon\""}}}},
    {.code = "axis-with-gaps",
     .rank = Rank::caution,
     .text = "the coordinate \"{axis}\" has missing values, so some of the data have no place or time",
     .hint = "Ask the producer for a complete file",
     .slots = {{{"axis", "lon"}}}},
    {.code = "axis-out-of-order",
     .rank = Rank::caution,
     .text = "the values of the coordinate \"{axis}\" must rise, or fall, from the first to the last. Here "
             "they {course}, but {one} is followed by {next}, so the places would be mixed up",
     .hint = "Ask the producer for a regular grid",
     .slots = {{{"axis", "lon"}, {"course", "rise"}, {"one", "10"}, {"next", "9"}}}},
    {.code = "longitudes-not-degrees",
     .rank = Rank::caution,
     .text = "the longitudes in \"{axis}\" run from {range}, so they are not degrees",
     .hint = "State the projection with --crs, or ask for a file in longitude and latitude",
     .slots = {{{"axis", "x"}, {"range", "0 to 900000"}}}},
    {.code = "latitudes-beyond-the-poles",
     .rank = Rank::caution,
     .text = "the latitudes in \"{axis}\" run from {range}, beyond the poles. The file is wrong, or its "
             "coordinates are not degrees",
     .hint = "Ask the producer, or state the projection with --crs",
     .slots = {{{"axis", "y"}, {"range", "0 to 900000"}}}},
    {.code = "times-twice",
     .rank = Rank::caution,
     .text = "the time axis \"{axis}\" has the same time at two steps, and it is not known which of the "
             "steps is right",
     .hint = "Remove one of them",
     .slots = {{{"axis", "time"}}}},
    {.code = "depth-axis-without-length",
     .rank = Rank::caution,
     .text = "the depth axis \"{axis}\" has the unit \"{unit}\", which is not a length, so the depths of the "
             "levels are not known",
     .hint = "Ask for levels in metres",
     .slots = {{{"axis", "depth"}, {"unit", "hPa"}}}},
    {.code = "axis-without-unit",
     .rank = Rank::note,
     .text = "the {what} \"{axis}\" states no unit and was read as metres",
     .hint = "Check that this is right",
     .slots = {{{"what", "depth axis"}, {"axis", "depth"}}}},
    {.code = "depths-negative-downwards",
     .rank = Rank::note,
     .text = "the depth axis \"{axis}\" claims to count downwards, but none of its values is above zero "
             "({range}). "
             "They were read as heights, which are negative below the sea surface",
     .slots = {{{"axis", "Z"}, {"range", "-100 to -5"}}}},
    {.code = "depths-impossible",
     .rank = Rank::caution,
     .text = "the depth axis \"{axis}\" runs from {range}, deeper than any ocean. Its unit or its direction "
             "is wrong",
     .hint = "Ask the producer",
     .slots = {{{"axis", "depth"}, {"range", "0 to 900000 m"}}}},
    {.code = "times-without-units",
     .rank = Rank::caution,
     .text =
         "the time axis \"{axis}\" has no units and therefore no starting date, so its times are not known",
     .hint = "Ask the producer for a file with units like \"hours since 2000-01-01\"",
     .slots = {{{"axis", "time"}}}},
    {.code = "times-rounded",
     .rank = Rank::caution,
     .text = "the times are stored with too few digits and may be wrong by {error_s} seconds",
     .hint = "Ask the producer for times with more digits",
     .slots = {{{"error_s", 600}}}},
    {.code = "julian-calendar",
     .rank = Rank::note,
     .text = "the file states its times in the Julian calendar, but producers mean the dates of today's "
             "calendar. The dates were read as such, without a shift of 13 days"},
    {.code = "model-calendar",
     .rank = Rank::caution,
     .text = "the file states its times in a model's own calendar (\"{calendar}\"). The dates were kept, "
             "but tides and weather at these dates are not the real ones",
     .hint = "Do not plan a real mission with these data",
     .slots = {{{"calendar", "360_day"}}}},
    {.code = "projected-axis-without-length",
     .rank = Rank::caution,
     .text = "the projected coordinate \"{axis}\" has the unit \"{unit}\", which is not a length, so the "
             "place of the grid is not known",
     .hint = "Ask for coordinates in metres",
     .slots = {{{"axis", "x"}, {"unit", "degree"}}}},
    {.code = "levels-above-the-bed",
     .rank = Rank::caution,
     .text = "the levels of \"{variable}\" (\"{axis}\") are heights above the sea bed, so their depths below "
             "the surface are not known",
     .hint = "Ask for depths below the surface",
     .slots = {{{"variable", "uo"}, {"axis", "height"}}}},
    {.code = "levels-without-depths",
     .rank = Rank::caution,
     .text = "the levels of \"{variable}\" (\"{axis}\") are {what}, so their depths or heights are not known",
     .hint = "Ask for levels in metres",
     .slots = {{{"variable", "uo"}, {"axis", "lev"}, {"what", "numbers of the model's levels"}}}},

    // NetCDF: grids.
    {.code = "projection-not-stated",
     .rank = Rank::caution,
     .text = "the grid of \"{variable}\" is projected, but the file does not state the projection, so the "
             "place of the grid is not known",
     .hint = "State the projection with --crs, for example --crs EPSG:3413",
     .slots = {{{"variable", "uo"}}}},
    {.code = "projection-not-usable",
     .rank = Rank::caution,
     .text = "the grid of \"{variable}\" has a projection that this program does not read from NetCDF",
     .hint = "Convert it first, for example with gdalwarp -t_srs EPSG:4326",
     .slots = {{{"variable", "uo"}}}},
    {.code = "projection-contradicts-tables",
     .rank = Rank::caution,
     .text = "the projection of \"{variable}\" places the grid elsewhere than its own tables of longitude "
             "and latitude, so its values would be out of place",
     .hint = "Convert it first to a regular longitude-latitude grid, with the tables",
     .slots = {{{"variable", "uo"}}}},
    {.code = "projection-unusable",
     .rank = Rank::caution,
     .text = "the projection of \"{variable}\" cannot be used ({reason})",
     .hint = "Convert the file first, for example with gdalwarp -t_srs EPSG:4326",
     .slots = {{{"variable", "uo"}, {"reason", "no such ellipsoid"}}}},
    {.code = "too-many-nodes",
     .rank = Rank::caution,
     .text = "{what} has {columns} x {rows} points, more than this program accepts ({most})",
     .hint = "Cut out your area first",
     .slots = {{{"what", "the grid"}, {"columns", 90000}, {"rows", 90000}, {"most", 100000000}}}},
    {.code = "too-many-points",
     .rank = Rank::caution,
     .text = "the grid of \"{variable}\" has more points than this program accepts",
     .hint = "Cut out your area first",
     .slots = {{{"variable", "uo"}}}},
    {.code = "levels-follow-the-bed",
     .rank = Rank::caution,
     .text = "the levels \"{dimension}\" follow the sea bed (a sigma or s coordinate), and the file does not "
             "give their depths in a form that this program reads",
     .hint = "Interpolate the data to depths in metres first",
     .slots = {{{"dimension", "s_rho"}}}},
    {.code = "without-plain-axes",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has no single axis of longitude and of latitude, so the places of "
             "its values are not known",
     .hint = "Ask for a regular longitude-latitude grid",
     .slots = {{{"variable", "uo"}}}},
    {.code = "dimension-empty",
     .rank = Rank::caution,
     .text = "the dimension \"{dimension}\" is empty, so the file holds no data",
     .hint = "Ask the producer for another file",
     .slots = {{{"dimension", "time"}}}},
    {.code = "dimension-too-long",
     .rank = Rank::caution,
     .text = "the dimension \"{dimension}\" has {size} values, more than this program accepts ({most}). The "
             "file is damaged or too large",
     .hint = "Cut out your area first",
     .slots = {{{"dimension", "time"}, {"size", 90000000}, {"most", 100000}}}},
    {.code = "final-and-preliminary",
     .rank = Rank::caution,
     .text = "\"{variable}\" holds final and preliminary data (ERA5 and ERA5T) side by side along "
             "\"{dimension}\", and each time is in only one of them",
     .hint = "Ask for the final data alone, or join both first",
     .slots = {{{"variable", "u10"}, {"dimension", "expver"}}}},
    {.code = "ensemble-members",
     .rank = Rank::caution,
     .text = "\"{variable}\" holds the members of an ensemble along \"{dimension}\"",
     .hint = "Take out one member first, for example with ncks -d {dimension},0 IN.nc OUT.nc",
     .slots = {{{"variable", "uo"}, {"dimension", "member"}}}},
    {.code = "several-forecasts",
     .rank = Rank::caution,
     .text = "\"{variable}\" holds forecasts of several lengths along \"{dimension}\", so no single "
             "coordinate gives the times for which they hold",
     .hint = "Take out one forecast run, or one length of forecast",
     .slots = {{{"variable", "uo"}, {"dimension", "step"}}}},
    {.code = "coordinates-of-another-group",
     .rank = Rank::caution,
     .text = "the coordinates \"{dimension}\" of \"{variable}\" lie in another group of the file ({group}), "
             "together with other data",
     .hint =
         "Put the coordinates and the variable into one group first, for example with ncks -G : IN.nc OUT.nc",
     .slots = {{{"dimension", "lon"}, {"variable", "uo"}, {"group", "/aux"}}}},
    {.code = "dimension-without-coordinates",
     .rank = Rank::caution,
     .text = "the dimension \"{dimension}\" of \"{variable}\" has no coordinates, so the places or times of "
             "its values are not known",
     .hint = "Ask for a file with longitude, latitude, depth and time coordinates",
     .slots = {{{"dimension", "n"}, {"variable", "uo"}}}},
    {.code = "times-without-start",
     .rank = Rank::caution,
     .text = "the time axis \"{axis}\" of \"{variable}\" counts in \"{unit}\" from a start that the file "
             "does not "
             "state, so its times are not known",
     .hint = "State the start of the run in its units, for example with ncatted -a "
             "\"units,{axis},o,c,seconds since "
             "2026-01-01\" FILE.nc",
     .slots = {{{"axis", "T"}, {"variable", "U"}, {"unit", "s"}}}},
    {.code = "layout-of-a-mesh",
     .rank = Rank::caution,
     .text = "the file is the output of a model on a mesh of triangles or cells, such as FVCOM, SELFE and "
             "UGRID write. On meshes this program reads only currents, and only if the nodes have longitudes "
             "and latitudes, which it does not find here",
     .hint = "Ask the producer for the longitudes and latitudes of the nodes, or interpolate the data to a "
             "regular longitude-latitude grid first"},
    {.code = "layout-of-roms",
     .rank = Rank::caution,
     .text = "the file is the output of a ROMS or CROCO model (a bent, staggered grid with levels that "
             "follow the sea bed). This program reads its currents, but not these data",
     .hint = "Interpolate the data to longitude, latitude and depth first"},
    {.code = "layout-of-a-bent-grid",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" lies on a curvilinear (bent) grid. This program reads currents, "
             "wind, sea ice and depths on such grids, but not this variable",
     .hint = "Interpolate it to a regular longitude-latitude grid first",
     .slots = {{{"variable", "siconc"}}}},
    {.code = "variable-unreadable",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" cannot be read to its end ({reason}). The file is damaged or was "
             "cut short",
     .hint = "Copy or download it again",
     .slots = {{{"variable", "uo"}, {"reason", "NetCDF: HDF error"}}}},
    {.code = "coordinate-too-long",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has {size} values along \"{dimension}\", more than any coordinate "
             "has, so the file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"variable", "lon"}, {"size", 90000000}, {"dimension", "x"}}}},

    // NetCDF: quality flags.
    {.code = "flags-not-read",
     .rank = Rank::caution,
     .text = "the quality flags \"{flags}\" of \"{variable}\" {fault}. They were not read, so bad values may "
             "be among the stored values",
     .hint = "Take out the flagged values first",
     .slots = {{{"flags", "uo_qc"}, {"variable", "uo"}, {"fault", "do not lie on its nodes"}}}},
    {.code = "flags-taken-as-usual",
     .rank = Rank::note,
     .text = "the quality flags \"{flags}\" do not say what their numbers mean. As is usual, 4 was read as "
             "bad, 9 as missing and 3 as {three}",
     .hint = "Ask the producer if that is wrong",
     .slots = {{{"flags", "uo_qc"}, {"three", "suspect"}}}},
    {.code = "flag-bits-unknown",
     .rank = Rank::caution,
     .text = "the quality flags \"{flags}\" do not say what each of their bits means, so the flagged values "
             "were kept",
     .hint = "Check these values before you plan",
     .slots = {{{"flags", "uo_qc"}}}},
    {.code = "flag-meanings-unknown",
     .rank = Rank::caution,
     .text = "the quality flags \"{flags}\" have unknown meanings ({meanings}), so the values with these "
             "flags were kept",
     .hint = "Check these values before you plan",
     .slots = {{{"flags", "uo_qc"}, {"meanings", "dubious_ish"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_netcdf_message(const Given&... given) {
  return make_message<ingest_netcdf_kinds, code>(given...);
}

}  // namespace floeplan::messages
