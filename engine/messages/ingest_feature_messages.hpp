#pragma once

#include "engine/messages/kind.hpp"

/// What a pilot is told of how a file of features is written: GeoJSON, KML, S-411 and what GDAL reads.
namespace floeplan::messages {

inline constexpr auto ingest_feature_kinds = std::to_array<Kind>({
    {.code = "geojson-unreadable",
     .rank = Rank::caution,
     .text = "the GeoJSON file cannot be read ({reason}): it is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "unexpected end"}}}},
    {.code = "features-missing",
     .rank = Rank::caution,
     .text = "the {format} holds no {what}: there is nothing to store",
     .hint = "Check what you exported",
     .slots = {{{"format", "GeoJSON file"}, {"what", "features"}}}},
    {.code = "geojson-in-other-crs",
     .rank = Rank::caution,
     .text = "the GeoJSON file uses the coordinate reference system \"{crs}\", but GeoJSON is longitude and "
             "latitude on WGS84",
     .hint = "Export it again in EPSG:4326",
     .slots = {{{"crs", "WGS 84 / UTM zone 22N"}}}},
    {.code = "kml-coordinates-unreadable",
     .rank = Rank::caution,
     .text = "the coordinates hold \"{text}\", which is no longitude,latitude",
     .hint = "Correct it",
     .slots = {{{"text", "52W"}}}},
    {.code = "kml-point-of-many",
     .rank = Rank::caution,
     .text = "a Point must have one place",
     .hint = "Correct it"},
    {.code = "kml-second-geometry",
     .rank = Rank::caution,
     .text = "the placemark has a second geometry",
     .hint = "Put both into a MultiGeometry"},
    {.code = "kml-not-handed-down",
     .rank = Rank::caution,
     .text = "the {element} states \"{word}\" for its contents, but KML hands it down to no placemark",
     .hint = "Give it to each of them",
     .slots = {{{"element", "Folder"}, {"word", "visibility"}}}},
    {.code = "kml-links-elsewhere",
     .rank = Rank::caution,
     .text = "the file links to another one (NetworkLink), which is not followed, so its contents would be "
             "missing",
     .hint = "Save all places into one file, or delete the link"},
    {.code = "kml-unreadable",
     .rank = Rank::caution,
     .text = "the KML file cannot be read: {reason}",
     .hint = "Correct it, or save it again",
     .slots = {{{"reason", "line 12: mismatched tag"}}}},
    {.code = "ice-gml-unreadable",
     .rank = Rank::caution,
     .text = "the S-411 chart cannot be read: {reason}",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "line 12: mismatched tag"}}}},
    {.code = "ice-gml-edition-not-read",
     .rank = Rank::caution,
     .text = "this is an S-411 chart of edition 1.2 or later, which does not say whether its corners begin "
             "with the "
             "longitude or the latitude. A wrong guess would move the ice",
     .hint =
         "Ask its producer for edition 1.1 (IceDataSet), or for the same chart as a shapefile (SIGRID-3)"},
    {.code = "ice-gml-corners-unreadable",
     .rank = Rank::caution,
     .text = "the corners of an area are not pairs of numbers that go round it",
     .hint = "Copy or download the chart again"},
    {.code = "ice-gml-axes-swapped",
     .rank = Rank::caution,
     .text =
         "an area has a corner at the latitude {latitude}. S-411 has latitudes first in EPSG:4326, so the "
         "chart seems to have its axes the other way round",
     .hint = "Ask its producer",
     .slots = {{{"latitude", "-120.5"}}}},
    {.code = "ice-gml-area-without-polygon",
     .rank = Rank::caution,
     .text = "an area of sea ice has no polygon, so nobody knows where its ice is",
     .hint = "Copy or download the chart again"},
    {.code = "ice-gml-stages-too-many",
     .rank = Rank::caution,
     .text = "an area of sea ice has more than five stages of development, more than any chart has",
     .hint = "Ask the producer of the chart"},
    {.code = "ice-gml-several-crs",
     .rank = Rank::caution,
     .text =
         "the areas of the S-411 chart are in {first} and {second}, but all must be in one reference system",
     .hint = "Ask its producer",
     .slots = {{{"first", "EPSG:4326"}, {"second", "EPSG:3995"}}}},
    {.code = "ice-gml-crs-unknown",
     .rank = Rank::caution,
     .text = "the reference system {crs} of the S-411 chart is not known",
     .hint = "Ask its producer for one in EPSG:4326",
     .slots = {{{"crs", "EPSG:1"}}}},
    {.code = "ice-gml-features-left-out",
     .rank = Rank::note,
     .text = "of the S-411 chart only areas of sea ice were read; left out: {features}",
     .slots = {{{"features", "icebrg and lacice"}}}},
    {.code = "table-value-too-long",
     .rank = Rank::caution,
     .text = "a value of the table does not fit its column, and would be left out ({reason})",
     .hint = "Correct it, or make the column one of texts",
     .slots = {{{"reason", "Invalid content for record 3"}}}},
    {.code = "features-unreadable",
     .rank = Rank::caution,
     .text = "not every feature of the file can be read ({reason}): it is damaged or holds texts larger "
             "than this program takes",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "not well-formed"}}}},
    {.code = "geopackage-with-code",
     .rank = Rank::caution,
     .text = "the GeoPackage holds {part}, which could run code of whoever made the file",
     .hint = "Save its layers into a new GeoPackage, for example with QGIS or ogr2ogr, and give that",
     .slots = {{{"part", "the trigger \"insert_all\""}}}},
    {.code = "geopackage-unreadable",
     .rank = Rank::caution,
     .text = "the GeoPackage cannot be read ({reason}): it is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "database disk image is malformed"}}}},
    {.code = "geopackage-of-tiles",
     .rank = Rank::caution,
     .text = "the file holds a raster in tiles. Of this format the program reads points and polygons only",
     .hint = "Convert a raster of depths with gdal_translate IN.gpkg OUT.tif, and give that"},
    {.code = "vector-file-unreadable",
     .rank = Rank::caution,
     .text = "the file cannot be read ({reason}): it is damaged, was cut short, or misses the files that "
             "belong to it (of a shapefile .shx and .dbf)",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "no .shx"}}}},
});

/// The message of this code; it is told its values in the order of the catalogue.
template <Code code, class... Given>
[[nodiscard]] Message ingest_feature_message(const Given&... given) {
  return make_message<ingest_feature_kinds, code>(given...);
}

}  // namespace floeplan::messages
