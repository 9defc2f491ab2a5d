#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about a file of currents or wind.
namespace floeplan::messages {

inline constexpr auto ingest_current_kinds = std::to_array<Kind>({
    // Times, levels and points.
    {.code = "current-times-missing",
     .rank = Rank::caution,
     .text = "the file does not say for which time its currents hold, and a plan needs to know",
     .hint = "Ask the producer for a file with a time axis"},
    {.code = "current-times-differ",
     .rank = Rank::caution,
     .text = "the two components of the current hold for different times and cannot be combined",
     .hint = "Give two files of the same period"},
    {.code = "current-depths-differ",
     .rank = Rank::caution,
     .text = "the two components of the current lie at different depths and cannot be combined",
     .hint = "Ask the producer for files with the same levels"},
    {.code = "sea-without-depth",
     .rank = Rank::caution,
     .text = "the sea has no depth anywhere in the file, so the depths of its levels are not known. The file "
             "is damaged or holds only land",
     .hint = "Ask the producer for another file"},
    {.code = "currents-too-large",
     .rank = Rank::caution,
     .text = "the file holds {times} times and {depths} depths of {nodes} nodes, more than this program "
             "accepts",
     .hint = "Cut out your area and period first",
     .slots = {{{"times", 5000}, {"depths", 50}, {"nodes", 4000000}}}},
    {.code = "currents-all-missing-or-flagged",
     .rank = Rank::caution,
     .text = "every value of {variables} is missing or flagged as bad by the file's own quality flags, so "
             "nothing was stored",
     .hint = "Check the area and the period of your download",
     .slots = {{{"variables", "uo and vo"}}}},
    {.code = "currents-all-missing",
     .rank = Rank::caution,
     .text = "every value of {variables} is missing, so nothing was stored",
     .hint = "Check the area and the period of your download",
     .slots = {{{"variables", "uo and vo"}}}},
    {.code = "currents-all-zero",
     .rank = Rank::caution,
     .text = "every {what} in the file is exactly zero. This is a file without data, not a calm",
     .hint = "Check the area and the period of your download",
     .slots = {{{"what", "current"}}}},
    {.code = "current-markers-left-out",
     .rank = Rank::note,
     .text = "{markers} {markers:value was|values were} left out, because {markers:it stands|they stand} for "
             "a missing current or {markers:lies|lie} outside the valid range that the file states",
     .slots = {{{"markers", 12}}}},
    {.code = "zeros-taken-as-land",
     .rank = Rank::note,
     .text = "no value of the currents is missing, but {share} % of their nodes are exactly zero at all "
             "times and lie together. These nodes count as land",
     .slots = {{{"share", "12.5"}}}},
    {.code = "flagged-bad-left-out",
     .rank = Rank::note,
     .text = "{values} {values:value was|values were} left out, because the file's own quality flags call "
             "{values:it|them} bad, failed or missing",
     .slots = {{{"values", 12}}}},
    {.code = "flagged-suspect-kept",
     .rank = Rank::caution,
     .text = "{values} {values:value was|values were} kept, although the file's own quality flags call "
             "{values:it|them} suspect",
     .hint = "Take out the values that you do not trust before you plan",
     .slots = {{{"values", 12}}}},
    {.code = "levels-follow-bed",
     .rank = Rank::note,
     .text = "the model's {levels} levels follow the sea bed and are kept with their depths. Between these "
             "depths the plan interpolates",
     .slots = {{{"levels", 30}}}},
    {.code = "current-above-first-level",
     .rank = Rank::caution,
     .text = "the currents begin at a depth of {depth} m. Above this depth the same current is used, but "
             "the water near the surface may run faster or in another direction",
     .hint = "Ingest currents that begin at the surface if you have them",
     .slots = {{{"depth", "5"}}}},

    // Speeds.
    {.code = "wind-too-strong",
     .rank = Rank::caution,
     .text = "the wind reaches {speed} m/s at {place}, stronger than any wind. The unit is wrong, or the "
             "file marks missing values without declaring them",
     .hint = "Ask the producer, or name the number that marks missing values with --missing, for example "
             "--missing -99.99",
     .slots = {{{"speed", "999"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "wind-too-strong-without-unit",
     .rank = Rank::caution,
     .text = "the wind reaches {speed} at {place}, and the file states no unit. In m/s no wind is that "
             "strong, so the unit is probably another",
     .hint = "Ask the producer",
     .slots = {{{"speed", "999"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "current-too-fast",
     .rank = Rank::caution,
     .text = "the current reaches {speed} m/s at {place}, faster than any ocean current. The unit is wrong, "
             "or the file marks missing values without declaring them",
     .hint = "Ask the producer, or name the number that marks missing values with --missing, for example "
             "--missing -99.99",
     .slots = {{{"speed", "99"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "current-too-fast-without-unit",
     .rank = Rank::caution,
     .text = "the current reaches {speed} at {place}, and the file states no unit. In m/s no ocean current "
             "is that fast, so the unit is probably cm/s",
     .hint = "Ask the producer, or add the units attribute",
     .slots = {{{"speed", "35"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "possible-marker",
     .rank = Rank::caution,
     .text = "at {points} points both components are exactly {value} m/s, and no value is {beyond}. This "
             "number probably marks missing values, although the file does not declare it",
     .hint = "If it does, remove the dataset. Then ingest the file again with --missing and this number as "
             "it stands in the file",
     .slots = {{{"points", 120}, {"value", "-9.99"}, {"beyond", "smaller"}}}},

    // Directions and axes.
    {.code = "axes-of-variable-unknown",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has no two dimensions that could be rows and columns, so the "
             "places of its values are not known",
     .hint = "Ask for a file with longitude, latitude, depth and time coordinates",
     .slots = {{{"variable", "uo"}}}},
    {.code = "bent-grid-without-positions",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" lies on a curvilinear (bent) grid, but the file holds no tables of "
             "longitude and latitude for its points. The places of its values are not known",
     .hint = "Give the model's grid or mesh file in the same command",
     .slots = {{{"variable", "uo"}}}},
    {.code = "called-eastward-on-a-turned-grid",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" are called eastward and northward. But they lie half a cell apart "
             "on a turned grid, as only components along the grid do, so their directions are not known",
     .hint = "Ask the producer",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "direction-of-components-unknown",
     .rank = Rank::caution,
     .text = "the file does not say whether \"{first}\" and \"{second}\" point towards east and north or "
             "along the axes of its {grid} grid. A wrong guess would turn the drift",
     .hint = "Ask the producer, or add standard names (eastward_sea_water_velocity or sea_water_x_velocity)",
     .slots = {{{"first", "uo"}, {"second", "vo"}, {"grid", "bent"}}}},
    {.code = "turned-from-model-grid",
     .rank = Rank::note,
     .text = "\"{first}\" and \"{second}\" point along the axes of the model's grid. They were turned to "
             "east and north, by up to {turn} degrees",
     .slots = {{{"first", "uo"}, {"second", "vo"}, {"turn", "28.4"}}}},
    {.code = "turned-from-projected-grid",
     .rank = Rank::note,
     .text = "\"{first}\" and \"{second}\" point along the axes of the projected grid. They were turned to "
             "east and north",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "along-parallels",
     .rank = Rank::note,
     .text = "\"{first}\" and \"{second}\" point along the axes of the model's grid, which here run along "
             "parallels and meridians",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "turned-as-grib-says",
     .rank = Rank::note,
     .text = "{what} along the axes of the grid, as the file says. They were turned to east and north, by up "
             "to {turn} degrees",
     .slots = {{{"what", "the currents point"}, {"turn", "28.4"}}}},
    {.code = "mesh-has-no-axes",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" are called components along a grid, but a mesh has no axes, so "
             "their directions are not known",
     .hint = "Ask the producer",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "mesh-components-apart",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" lie at different places of the mesh, one on the nodes and one in "
             "the faces, and cannot be combined",
     .hint = "Ask the producer",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "staggered-plain-axes",
     .rank = Rank::caution,
     .text = "the components \"{first}\" and \"{second}\" lie on different points of a staggered grid with "
             "plain axes, and it is not known which points belong together",
     .hint = "Interpolate both to the same points first",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "along-bent-axes",
     .rank = Rank::caution,
     .text = "the components \"{first}\" and \"{second}\" point along the axes of the model's grid. "
             "The data reach latitude {latitude}, where the grid of a global model is bent round "
             "poles on land, so these axes may not be east and north",
     .hint = "Give the model's file of positions (geolon_c and geolat_c, or nav_lon and nav_lat) in the same "
             "command, or keep only the part south of latitude {limit}",
     .slots = {{{"first", "u"}, {"second", "v"}, {"latitude", "80"}, {"limit", "65"}}}},
    {.code = "levels-not-of-the-bed",
     .rank = Rank::caution,
     .text = "the levels follow the sea bed, which this program does not read in {what}",
     .hint = "Interpolate the data to depths in metres first",
     .slots = {{{"what", "a regular grid"}}}},

    // Part of the water column.
    {.code = "current-of-one-depth",
     .rank = Rank::caution,
     .text = "{variables} are currents at a depth of {depth} m, as the file says. Below this depth the "
             "current is unknown",
     .hint = "Ingest currents of more depths if the vehicle dives deeper",
     .slots = {{{"variables", "\"uo\" and \"vo\""}, {"depth", "15"}}}},
    {.code = "current-of-the-surface",
     .rank = Rank::caution,
     .text = "{variables} are currents of the surface alone and were stored at depth 0. A plan with "
             "deeper dives uses them at all depths, where the true current may be weaker",
     .hint = "Ingest currents of more depths if you have them",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-of-the-column",
     .rank = Rank::caution,
     .text = "{variables} are means over the whole water column or a part of it. They were stored as the "
             "same at every depth, but near the surface the true current may be much stronger or run in "
             "another direction",
     .hint = "Ingest currents with depths if you have them",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-without-depth",
     .rank = Rank::caution,
     .text = "{variables} state no depth and were stored as the same at every depth",
     .hint = "If they are those of one depth only, state this depth, for example with ncap2 -s 'depth=0.0; "
             "depth@standard_name=\"depth\"; depth@units=\"m\"' IN.nc OUT.nc",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-above-the-surface",
     .rank = Rank::caution,
     .text = "the levels of \"{first}\" and \"{second}\" lie above the sea surface (heights of up to "
             "{height} m), so the depths of these currents are not known",
     .hint = "Ask for depths below the surface",
     .slots = {{{"first", "uo"}, {"second", "vo"}, {"height", "10"}}}},

    // ADCIRC.
    {.code = "adcirc-without-currents",
     .rank = Rank::caution,
     .text = "the file holds {what} of an ADCIRC run but no currents",
     .hint = "Give fort.64 and its mesh, fort.14, in one command",
     .slots = {{{"what", "the mesh"}}}},
    {.code = "adcirc-without-mesh",
     .rank = Rank::caution,
     .text = "the file holds currents of an ADCIRC run, but not the places of its nodes",
     .hint = "Give the mesh of the run, fort.14, in the same command"},
    {.code = "adcirc-without-start",
     .rank = Rank::caution,
     .text = "ADCIRC counts seconds from the start of its run, but its files do not state this start",
     .hint = "State it with --time, for example --time 2026-03-01T00:00:00Z"},
    {.code = "adcirc-meshes-differ",
     .rank = Rank::caution,
     .text = "the currents have {nodes} nodes, but the mesh has {of_mesh} nodes",
     .hint = "Give the mesh with which the model ran",
     .slots = {{{"nodes", 30000}, {"of_mesh", 28000}}}},
    {.code = "adcirc-times-differ",
     .rank = Rank::caution,
     .text = "the elevations of the surface (fort.63) hold for other times or another mesh than the currents "
             "(fort.64)",
     .hint = "Give both files of the same run and interval, or fort.64 alone"},
    {.code = "adcirc-line-unreadable",
     .rank = Rank::caution,
     .text = "line {line} of an ADCIRC file is \"{words}\" instead of {expected}, so the file is "
             "damaged",
     .hint = "Copy or download it again",
     .slots = {{{"line", 120}, {"words", "12 -9.5"}, {"expected", "a node and its elevation"}}}},
    {.code = "adcirc-file-cut-short",
     .rank = Rank::caution,
     .text = "an ADCIRC file ends before the end of line {line}, which must hold {expected}, so it "
             "was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"line", 120}, {"expected", "a node and its elevation"}}}},
    {.code = "adcirc-not-in-degrees",
     .rank = Rank::caution,
     .text = "the mesh has a node at {x}, {y}, which is not a longitude and latitude in degrees",
     .hint = "Give a mesh in geographic coordinates (ICS = 2)",
     .slots = {{{"x", "512000"}, {"y", "5900000"}}}},
    {.code = "adcirc-zeros-are-dry",
     .rank = Rank::note,
     .text = "a node counts as dry at each time at which its current is exactly zero",
     .hint = "Give the elevations of the same run, fort.63, too, because they say which nodes are dry"},
    // Wind.
    {.code = "wind-at-other-height",
     .rank = Rank::caution,
     .text = "the wind is given at {height} m, not at 10 m above the ground. The wind that moves an iceberg "
             "is weaker than the wind higher up",
     .hint = "Ask for the wind at 10 m",
     .slots = {{{"height", "80"}}}},
    {.code = "wind-on-model-levels",
     .rank = Rank::caution,
     .text = "the wind \"{first}\" and \"{second}\" is given on levels of the model (\"{level}\"), whose "
             "height above the sea is not known",
     .hint = "Ask for the wind at 10 m",
     .slots = {{{"first", "u"}, {"second", "v"}, {"level", "lev"}}}},
    {.code = "wind-without-height",
     .rank = Rank::caution,
     .text = "the file does not state the height of the wind \"{first}\" and \"{second}\". It counts as "
             "the wind 10 m above the sea",
     .hint = "Check its height with the producer",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_current_message(const Given&... given) {
  return make_message<ingest_current_kinds, code>(given...);
}

}  // namespace floeplan::messages
