#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the format of an HDF5 file, including S-100 files.
namespace floeplan::messages {

inline constexpr auto ingest_hdf5_kinds = std::to_array<Kind>({
    // HDF5.
    {.code = "hdf-part-unreadable",
     .rank = Rank::caution,
     .text = "\"{part}\" of the HDF5 file cannot be read. The file is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"part", "/SurfaceCurrent"}}}},
    {.code = "hdf-leads-elsewhere",
     .rank = Rank::caution,
     .text = "\"{part}\" {reason}. This program reads only the given file and does not follow such links",
     .hint = "Copy everything into one file, for example with nccopy, and give that",
     .slots = {{{"part", "uo"}, {"reason", "has its values in another file"}}}},
    {.code = "hdf-hides-something",
     .rank = Rank::caution,
     .text = "the file cannot be read to its end. It is damaged or was cut short, and the part that "
             "cannot be read could refer to other files",
     .hint = "Copy or download it again"},

    // S-100.
    {.code = "s-hundred-incomplete",
     .rank = Rank::caution,
     .text = "the S-100 file does not say {what}, so the places of its values are not known",
     .hint = "Ask its producer for a complete file",
     .slots = {{{"what", "where its grid lies (gridOriginLongitude)"}}}},
    {.code = "s-hundred-crs-unknown",
     .rank = Rank::caution,
     .text = "the reference system EPSG:{code} of the S-100 file is not known",
     .hint = "Ask its producer for a file in longitude and latitude (EPSG:4326)",
     .slots = {{{"code", "1"}}}},
    {.code = "s-hundred-crs-unusable",
     .rank = Rank::caution,
     .text = "the S-100 file is in the reference system EPSG:{code}, which this program does not use",
     .hint = "Ask its producer for one in longitude and latitude (EPSG:4326), or in UTM",
     .slots = {{{"code", "27700"}}}},
    {.code = "s-hundred-beyond-projection",
     .rank = Rank::caution,
     .text = "the grid of the S-100 file reaches beyond what the projection of its reference system can show, so "
             "some of its nodes have no place",
     .hint = "Check its horizontalCRS, gridOriginLongitude and gridOriginLatitude, or ask its producer"},
    {.code = "s-hundred-without-values",
     .rank = Rank::caution,
     .text = "the S-100 file holds no values of {feature}, so nothing was stored",
     .hint = "Check what you were sent",
     .slots = {{{"feature", "SurfaceCurrent"}}}},
    {.code = "s-hundred-areas",
     .rank = Rank::caution,
     .text = "the S-100 file holds {areas} areas of {feature}, each on its own grid, but this program reads "
             "only files with one area",
     .hint = "Ask its producer for a file for each area",
     .slots = {{{"areas", 3}, {"feature", "SurfaceCurrent"}}}},
    {.code = "s-hundred-too-many-records",
     .rank = Rank::caution,
     .text = "the S-100 file holds more than 100000 records, the most that this program reads",
     .hint = "Cut out your period first"},
    {.code = "s-hundred-records-missing",
     .rank = Rank::caution,
     .text = "the S-100 file announces {announced} records, but has only {records}. It is damaged or was cut "
             "short",
     .hint = "Copy or download it again",
     .slots = {{{"announced", "24"}, {"records", 12}}}},
    {.code = "s-hundred-record-of-other-size",
     .rank = Rank::caution,
     .text = "a record of the S-100 file has other rows and columns than its grid, so the file is damaged",
     .hint = "Copy or download it again"},
    {.code = "s-hundred-layout-not-read",
     .rank = Rank::caution,
     .text =
         "the values of {feature} in the S-100 file belong to {layout}. This program reads only regular "
         "grids, and currents at separate places and on triangulated meshes (data coding formats 2, 3 and 7)",
     .hint = "Ask its producer for such a file",
     .slots = {{{"feature", "SurfaceCurrent"}, {"layout", "cells of several sizes"}}}},
    {.code = "s-hundred-of-stations",
     .rank = Rank::caution,
     .text = "the values of {feature} in the S-100 file belong to fixed stations (data coding format "
             "{format}). They do not tell the water between the stations, which a plan crosses",
     .hint = "Ask its producer for the same data on a grid or a mesh (data coding format 2, 3 or 7), or give "
             "the output of the model",
     .slots = {{{"feature", "SurfaceCurrent"}, {"format", "8"}}}},
    {.code = "s-hundred-of-a-platform",
     .rank = Rank::caution,
     .text =
         "the values of {feature} in the S-100 file were taken along the track of a moving platform (data "
         "coding format {format}), each at one place and one moment. A plan needs them over an area and a "
         "period",
     .hint = "Ask its producer for a grid or a mesh (data coding format 2, 3 or 7), or give the output of a "
             "model",
     .slots = {{{"feature", "SurfaceCurrent"}, {"format", "4"}}}},
    {.code = "s-hundred-triangle-impossible",
     .rank = Rank::caution,
     .text = "a triangle of the S-100 file has a corner at place {place}, but the places are numbered from 0 "
             "to one less than {places}, so the file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"place", 12}, {"places", 12}}}},
    {.code = "s-hundred-places-projected",
     .rank = Rank::caution,
     .text =
         "the values of the S-100 file lie at separate places that are not given in longitude and latitude",
     .hint = "Ask its producer for a file in longitude and latitude (EPSG:4326)"},
    {.code = "s-hundred-place-impossible",
     .rank = Rank::caution,
     .text = "a place of the S-100 file is {lon} degrees east, {lat} degrees north, which is not on the "
             "Earth, so the file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"lon", "-999"}, {"lat", "45"}}}},
    {.code = "s-hundred-order-not-read",
     .rank = Rank::caution,
     .text = "the grid of the S-100 file runs in an order that this program does not read",
     .hint = "Ask its producer for a file whose rows run from south to north"},

    {.code = "s-places-without-area",
     .rank = Rank::caution,
     .text = "the places of the values enclose no area. Nothing is known between fewer than three "
             "places, or between places on one line",
     .hint = "Ask the producer for a file of a larger area"},
    {.code = "s-time-unreadable",
     .rank = Rank::caution,
     .text = "a record of the S-100 file has the unreadable time \"{text}\", so the file is damaged",
     .hint = "Copy or download it again",
     .slots = {{{"text", "yesterday"}}}},

    // S-111.
    {.code = "s-depth-missing",
     .rank = Rank::caution,
     .text = "the S-111 file has no number for the depth of its currents, so it is damaged",
     .hint = "Copy or download it again"},
    {.code = "s-depth-from-the-bed",
     .rank = Rank::caution,
     .text = "the depth of the currents in the S-111 file counts neither from the surface nor from a chart "
             "datum, so their depth in the water is not known",
     .hint = "Ask its producer for currents below the surface"},
    {.code = "s-speed-unit-unknown",
     .rank = Rank::caution,
     .text = "the speeds of the S-111 file have the unit \"{unit}\", which is not a known speed",
     .hint = "Ask its producer for a file in knots",
     .slots = {{{"unit", "furlong"}}}},
    {.code = "uppermost-layer",
     .rank = Rank::note,
     .text = "the currents are means over the uppermost {depth} m of the water. They count for the middle of "
             "this layer",
     .slots = {{{"depth", "10"}}}},
    {.code = "depth-from-chart-datum",
     .rank = Rank::note,
     .text = "the depth of the currents, {depth} m, counts from the chart datum. It was read as the "
             "depth below the surface, which is wrong by the height of the tide",
     .slots = {{{"depth", "4.5"}}}},

    // S-104.
    {.code = "level-unit-unknown",
     .rank = Rank::caution,
     .text = "the water levels of the S-104 file have the unit \"{unit}\", which is not a known length",
     .hint = "Ask its producer for a file in metres",
     .slots = {{{"unit", "furlong"}}}},
    {.code = "level-datum-missing",
     .rank = Rank::caution,
     .text = "the S-104 file does not say from which vertical datum its water levels count (verticalDatum "
             "{code}), so "
             "they say nothing of the depth of the water",
     .hint = "Ask its producer for a file with a datum of S-100 or EPSG",
     .slots = {{{"code", "48"}}}},
    {.code = "level-sign-unknown",
     .rank = Rank::caution,
     .text = "the vertical axis of the S-104 file is not heights upwards in metres ({attribute} is {code}, "
             "not {wanted}). "
             "A level with the wrong sign would be wrong by twice the tide",
     .hint = "Ask its producer for a file with heights above its vertical datum (verticalCS 6499)",
     .slots = {{{"attribute", "verticalCS"}, {"code", "6498"}, {"wanted", "6499"}}}},
    {.code = "level-impossible",
     .rank = Rank::caution,
     .text = "a water level of the S-104 file is {height} m, but S-104 has none beyond 99.99 m. The unit or "
             "the file is "
             "wrong",
     .hint = "Ask its producer",
     .slots = {{{"height", "1200"}}}},
    {.code = "levels-all-missing",
     .rank = Rank::caution,
     .text = "every water level of the S-104 file is missing, so nothing was stored",
     .hint = "Check the area and the period of your download"},
    {.code = "levels-too-large",
     .rank = Rank::caution,
     .text = "the water levels have {times} times of {nodes} places, more than the {most} values that "
             "this program accepts",
     .hint = "Cut out your area or period first",
     .slots = {{{"times", 100000}, {"nodes", 100000}, {"most", 4000000000}}}},
    {.code = "level-stations-unequal",
     .rank = Rank::caution,
     .text = "the S-104 file has {records} series for {places} stations, so it is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"records", 3}, {"places", 4}}}},
    {.code = "levels-above-datum",
     .rank = Rank::note,
     .text = "the water levels are heights above their datum ({datum}). `floeplan probe` shows them. "
             "Plans take depths from the bathymetry alone and do not add the levels",
     .slots = {{{"datum", "lowest astronomical tide"}}}},
    {.code = "levels-below-datum",
     .rank = Rank::caution,
     .text = "the water falls to {fall} m below its datum ({datum}). Depths that count from this "
             "datum are then too great by as much, and plans do not correct them",
     .hint = "Keep the vehicle farther from the sea bed by at least this amount (--altimeter-margin)",
     .slots = {{{"fall", "0.62"}, {"datum", "mean lower low water"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_hdf5_message(const Given&... given) {
  return make_message<ingest_hdf5_kinds, code>(given...);
}

}  // namespace floeplan::messages
