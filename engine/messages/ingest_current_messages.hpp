#pragma once

#include "engine/messages/kind.hpp"

/// What a pilot is told of a file of currents or wind.
namespace floeplan::messages {

inline constexpr auto ingest_current_kinds = std::to_array<Kind>({
    // Times, levels and points.
    {.code = "current-times-missing",
     .rank = Rank::caution,
     .text = "the file does not say for which time its currents hold, and a plan needs to know",
     .hint = "Ask the producer for a file with a time axis"},
    {.code = "current-times-differ",
     .rank = Rank::caution,
     .text = "the two components of the current hold for different times: they cannot be put together",
     .hint = "Give the two files of the same period"},
    {.code = "current-depths-differ",
     .rank = Rank::caution,
     .text = "the two components of the current lie at different depths: they cannot be put together",
     .hint = "Ask the producer for files with the same levels"},
    {.code = "sea-without-depth",
     .rank = Rank::caution,
     .text = "the sea has no depth anywhere in the file, so its levels cannot be placed. The file is "
             "damaged or holds land only",
     .hint = "Ask the producer for another"},
    {.code = "currents-too-large",
     .rank = Rank::caution,
     .text = "the file holds {times} times and {depths} depths of {nodes} nodes, more than this program "
             "accepts",
     .hint = "Cut out your area and period first",
     .slots = {{{"times", 5000}, {"depths", 50}, {"nodes", 4000000}}}},
    {.code = "currents-all-missing-or-flagged",
     .rank = Rank::caution,
     .text = "every value of {variables} is missing or flagged as bad by the file's own quality flags: "
             "there is nothing to store",
     .hint = "Check the area and the period of your download",
     .slots = {{{"variables", "uo and vo"}}}},
    {.code = "currents-all-missing",
     .rank = Rank::caution,
     .text = "every value of {variables} is missing: there is nothing to store",
     .hint = "Check the area and the period of your download",
     .slots = {{{"variables", "uo and vo"}}}},
    {.code = "currents-all-zero",
     .rank = Rank::caution,
     .text = "every {what} in the file is exactly zero: a file without data, not a calm",
     .hint = "Check the area and the period of your download",
     .slots = {{{"what", "current"}}}},
    {.code = "current-markers-left-out",
     .rank = Rank::note,
     .text =
         "{markers} {markers:value|values} left out: {markers:it stands|they stand} for a missing current, "
         "although "
         "the file does not declare that, or {markers:lies|lie} outside the valid range that the file states",
     .slots = {{{"markers", 12}}}},
    {.code = "zeros-taken-as-land",
     .rank = Rank::note,
     .text = "no value of the currents is missing, but {share} % of their nodes are exactly zero at all "
             "times and lie together; they count as land",
     .slots = {{{"share", "12.5"}}}},
    {.code = "flagged-bad-left-out",
     .rank = Rank::note,
     .text = "{values} {values:value is|values are} flagged as bad, failed or missing by the file's own "
             "quality flags and left out",
     .slots = {{{"values", 12}}}},
    {.code = "flagged-suspect-kept",
     .rank = Rank::caution,
     .text = "{values} {values:value is|values are} flagged as suspect by the file's own quality flags and "
             "kept",
     .hint = "Take out what you do not trust before you plan",
     .slots = {{{"values", 12}}}},
    {.code = "levels-follow-bed",
     .rank = Rank::note,
     .text = "the model's {levels} levels follow the sea bed and are kept with their depths; between them "
             "values are "
             "interpolated when they are used",
     .slots = {{{"levels", 30}}}},
    {.code = "current-above-first-level",
     .rank = Rank::caution,
     .text = "the currents begin at a depth of {depth} m. Above it the current of that depth is used, "
             "although the water near the surface may run faster or another way",
     .slots = {{{"depth", "5"}}}},

    // How strong.
    {.code = "wind-too-strong",
     .rank = Rank::caution,
     .text = "the wind reaches {speed} m/s at {place}, but no wind is that strong. The unit is wrong, or "
             "the file marks missing values without declaring them",
     .hint = "Ask the producer, or name the number that marks them with --missing, for example --missing "
             "-99.99",
     .slots = {{{"speed", "999"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "wind-too-strong-without-unit",
     .rank = Rank::caution,
     .text = "the wind reaches {speed} at {place}, but no wind is that strong. The file states no unit, and "
             "it is probably not m/s",
     .hint = "Ask the producer",
     .slots = {{{"speed", "999"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "current-too-fast",
     .rank = Rank::caution,
     .text = "the current reaches {speed} m/s at {place}, but no ocean is that fast. The unit is wrong, or "
             "the file marks missing values without declaring them",
     .hint = "Ask the producer, or name the number that marks them with --missing, for example --missing "
             "-99.99",
     .slots = {{{"speed", "99"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "current-too-fast-without-unit",
     .rank = Rank::caution,
     .text = "the current reaches {speed} at {place}, and the file states no unit. In m/s no ocean is that "
             "fast, so the unit is probably cm/s",
     .hint = "Ask the producer, or add the units attribute",
     .slots = {{{"speed", "35"}, {"place", "longitude -52, latitude 69"}}}},
    {.code = "possible-marker",
     .rank = Rank::caution,
     .text = "at {points} points both components are exactly {value} m/s and none is {beyond}: this "
             "number probably marks missing values, although the file does not declare it",
     .hint = "If it does, remove the dataset and ingest the file again with --missing and the number as the "
             "file has it",
     .slots = {{{"points", 120}, {"value", "-9.99"}, {"beyond", "smaller"}}}},

    // Which way it points.
    {.code = "axes-of-variable-unknown",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" has no two dimensions that could be rows and columns: the data "
             "cannot be placed",
     .hint = "Ask for a file with longitude, latitude, depth and time coordinates",
     .slots = {{{"variable", "uo"}}}},
    {.code = "bent-grid-without-positions",
     .rank = Rank::caution,
     .text = "the variable \"{variable}\" lies on a curvilinear (bent) grid, and the file holds no tables "
             "of longitude and latitude for its points: the data cannot be placed",
     .hint = "Give the model's grid or mesh file in the same command",
     .slots = {{{"variable", "uo"}}}},
    {.code = "called-eastward-on-a-turned-grid",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" are called eastward and northward, yet they lie half a cell "
             "apart on a turned grid, as only components along the grid do. Which of the two is true is not "
             "known",
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
     .text = "\"{first}\" and \"{second}\" point along the axes of the model's grid; they were turned to "
             "east and north, by up to {turn} degrees",
     .slots = {{{"first", "uo"}, {"second", "vo"}, {"turn", "28.4"}}}},
    {.code = "turned-from-projected-grid",
     .rank = Rank::note,
     .text = "\"{first}\" and \"{second}\" point along the axes of the projected grid; they were turned to "
             "east and north",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "along-parallels",
     .rank = Rank::note,
     .text = "\"{first}\" and \"{second}\" point along the axes of the model's grid, which here run along "
             "parallels and meridians",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "turned-as-grib-says",
     .rank = Rank::note,
     .text = "{what} along the axes of the grid, as the file says; turned to east and north, by up to "
             "{turn} degrees",
     .slots = {{{"what", "the currents point"}, {"turn", "28.4"}}}},
    {.code = "mesh-has-no-axes",
     .rank = Rank::caution,
     .text = "\"{first}\" and \"{second}\" are called components along a grid, but a mesh has no axes. It is "
             "not known which way they point",
     .hint = "Ask the producer",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "mesh-components-apart",
     .rank = Rank::caution,
     .text =
         "\"{first}\" and \"{second}\" lie at different places of the mesh, one on the nodes and one in the "
         "faces: they cannot be combined",
     .hint = "Ask the producer",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
    {.code = "staggered-plain-axes",
     .rank = Rank::caution,
     .text = "the components \"{first}\" and \"{second}\" lie on different points of a staggered grid with "
             "plain axes. It is not known which is beside which",
     .hint = "Interpolate both to the same points first",
     .slots = {{{"first", "uo"}, {"second", "vo"}}}},
    {.code = "along-bent-axes",
     .rank = Rank::caution,
     .text = "the components \"{first}\" and \"{second}\" point along the axes of the model's grid, and up "
             "to latitude {latitude} the grid of a global model is bent round poles on land, so its axes "
             "are not east and north",
     .hint = "Give the model's file of positions (geolon_c and geolat_c, or nav_lon and nav_lat) in the "
             "same command, or cut out the part south of {limit}",
     .slots = {{{"first", "u"}, {"second", "v"}, {"latitude", "80"}, {"limit", "65"}}}},
    {.code = "levels-not-of-the-bed",
     .rank = Rank::caution,
     .text = "levels that follow the sea bed are not possible in {what}",
     .slots = {{{"what", "a regular grid"}}}},

    // The part of the water.
    {.code = "current-of-one-depth",
     .rank = Rank::caution,
     .text = "{variables} are currents at a depth of {depth} m, as the file says; below it the current is "
             "unknown",
     .slots = {{{"variables", "\"uo\" and \"vo\""}, {"depth", "15"}}}},
    {.code = "current-of-the-surface",
     .rank = Rank::caution,
     .text = "{variables} are currents of the surface alone. They were stored at depth 0, and a plan for "
             "deeper dives uses them all the way down",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-of-the-column",
     .rank = Rank::caution,
     .text = "{variables} are means over the whole water column or a part of it. They were stored as the "
             "same at every depth, but near the surface the current may be much stronger or run another way",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-without-depth",
     .rank = Rank::caution,
     .text = "{variables} state no depth and were stored as the same at every depth",
     .hint = "If they are those of one depth alone, state it, for example with ncap2 -s 'depth=0.0; "
             "depth@standard_name=\"depth\"; depth@units=\"m\"' IN.nc OUT.nc",
     .slots = {{{"variables", "\"uo\" and \"vo\""}}}},
    {.code = "current-above-the-surface",
     .rank = Rank::caution,
     .text = "the levels of \"{first}\" and \"{second}\" lie above the surface of the sea (heights of up to "
             "{height} m). It is not known where in the water these currents run",
     .hint = "Ask for depths below the surface",
     .slots = {{{"first", "uo"}, {"second", "vo"}, {"height", "10"}}}},

    // ADCIRC.
    {.code = "adcirc-without-currents",
     .rank = Rank::caution,
     .text = "the file holds {what} of a run of ADCIRC and no currents",
     .hint = "Give fort.64 with its mesh, fort.14, in one command",
     .slots = {{{"what", "the mesh"}}}},
    {.code = "adcirc-without-mesh",
     .rank = Rank::caution,
     .text = "the file holds currents of a run of ADCIRC, but not where its nodes lie",
     .hint = "Give the mesh of the run, fort.14, in the same command"},
    {.code = "adcirc-without-start",
     .rank = Rank::caution,
     .text = "ADCIRC counts seconds from the start of its run, and its files do not say when that was",
     .hint = "State it, for example --time 2026-03-01T00:00:00Z"},
    {.code = "adcirc-meshes-differ",
     .rank = Rank::caution,
     .text = "the currents are those of {nodes} nodes, and the mesh has {of_mesh}",
     .hint = "Give the mesh with which the model ran",
     .slots = {{{"nodes", 30000}, {"of_mesh", 28000}}}},
    {.code = "adcirc-times-differ",
     .rank = Rank::caution,
     .text = "the elevations of the surface (fort.63) hold for other times or another mesh than the currents",
     .hint = "Give both of the same run and interval, or fort.64 alone"},
    {.code = "adcirc-line-unreadable",
     .rank = Rank::caution,
     .text = "line {line} of a file of ADCIRC is \"{words}\", where {expected} was expected",
     .hint = "The file is damaged; fetch it again",
     .slots = {{{"line", 120}, {"words", "12 -9.5"}, {"expected", "a node and its elevation"}}}},
    {.code = "adcirc-file-cut-short",
     .rank = Rank::caution,
     .text = "a file of ADCIRC ends before the end of line {line}, where {expected} was expected",
     .hint = "It was cut short; fetch it again",
     .slots = {{{"line", 120}, {"expected", "a node and its elevation"}}}},
    {.code = "adcirc-not-in-degrees",
     .rank = Rank::caution,
     .text = "the mesh has a node at {x}, {y}: these are no longitude and latitude in degrees",
     .hint = "Give a mesh in geographic coordinates (ICS = 2)",
     .slots = {{{"x", "512000"}, {"y", "5900000"}}}},
    {.code = "adcirc-zeros-are-dry",
     .rank = Rank::note,
     .text = "nodes at which the current is exactly zero count as dry at that time",
     .hint = "Give the elevations of the same run, fort.63, too: they say which nodes are dry"},
    // Wind.
    {.code = "wind-at-other-height",
     .rank = Rank::caution,
     .text = "the wind is given at {height} m, but not at 10 m above the ground. Higher up it is stronger "
             "than the wind that moves an iceberg",
     .hint = "Ask for the wind at 10 m",
     .slots = {{{"height", "80"}}}},
    {.code = "wind-on-model-levels",
     .rank = Rank::caution,
     .text = "the wind \"{first}\" and \"{second}\" lies on levels of the model (\"{level}\"), whose height "
             "above the sea is not known",
     .hint = "Ask for the wind at 10 m",
     .slots = {{{"first", "u"}, {"second", "v"}, {"level", "lev"}}}},
    {.code = "wind-without-height",
     .rank = Rank::caution,
     .text = "the file does not say at which height the wind of \"{first}\" and \"{second}\" is known; it "
             "counts as the wind 10 m above the sea",
     .slots = {{{"first", "u"}, {"second", "v"}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message ingest_current_message(const Given&... given) {
  return make_message<ingest_current_kinds, code>(given...);
}

}  // namespace floeplan::messages
