#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the format of a file of features: GeoJSON, KML, S-411 and the formats that
/// GDAL reads.
namespace floeplan::messages {

inline constexpr auto ingest_feature_kinds = std::to_array<Kind>({
    {.code = "geojson-unreadable",
     .rank = Rank::caution,
     .text = "the GeoJSON file cannot be read ({reason}). It is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "unexpected end"}}}},
    {.code = "features-missing",
     .rank = Rank::caution,
     .text = "the {format} holds no {what}, so nothing was stored",
     .hint = "Check what you exported",
     .slots = {{{"format", "GeoJSON file"}, {"what", "features"}}}},
    {.code = "geojson-in-other-crs",
     .rank = Rank::caution,
     .text = "the GeoJSON file uses the coordinate reference system \"{crs}\", but GeoJSON must be in "
             "longitude and latitude on WGS84",
     .hint = "Export it again in EPSG:4326",
     .slots = {{{"crs", "WGS 84 / UTM zone 22N"}}}},
    {.code = "kml-coordinates-unreadable",
     .rank = Rank::caution,
     .text = "the coordinates hold \"{text}\", which is not longitude,latitude",
     .hint = "Correct it",
     .slots = {{{"text", "52W"}}}},
    {.code = "kml-point-of-many",
     .rank = Rank::caution,
     .text = "a Point must have only one place",
     .hint = "Correct it"},
    {.code = "kml-second-geometry",
     .rank = Rank::caution,
     .text = "the placemark has two geometries",
     .hint = "Put both into a MultiGeometry"},
    {.code = "kml-not-handed-down",
     .rank = Rank::caution,
     .text = "the {element} states \"{word}\", but KML does not pass it on to the placemarks inside",
     .hint = "Give it to each placemark",
     .slots = {{{"element", "Folder"}, {"word", "visibility"}}}},
    {.code = "kml-links-elsewhere",
     .rank = Rank::caution,
     .text = "the file links to another file (NetworkLink). Such links are not followed, so the places of "
             "that file would be missing",
     .hint = "Save all places into one file, or delete the link"},
    {.code = "kml-unreadable",
     .rank = Rank::caution,
     .text = "the KML file cannot be read ({reason})",
     .hint = "Correct it, or save it again",
     .slots = {{{"reason", "line 12: mismatched tag"}}}},
    {.code = "ice-gml-unreadable",
     .rank = Rank::caution,
     .text = "the S-411 chart cannot be read ({reason})",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "line 12: mismatched tag"}}}},
    {.code = "ice-gml-edition-not-read",
     .rank = Rank::caution,
     .text = "this is an S-411 chart of edition 1.2 or later, which does not say whether longitude or "
             "latitude comes first in the corners of its areas. A wrong guess would move the ice",
     .hint =
         "Ask its producer for edition 1.1 (IceDataSet), or for the same chart as a shapefile (SIGRID-3)"},
    {.code = "ice-gml-corners-unreadable",
     .rank = Rank::caution,
     .text = "the corners of an area are not a closed outline of pairs of numbers",
     .hint = "Copy or download the chart again"},
    {.code = "ice-gml-axes-swapped",
     .rank = Rank::caution,
     .text = "an area has a corner at the latitude {latitude}. In S-411 the latitude comes first, so the "
             "chart seems to have longitude and latitude swapped",
     .hint = "Ask its producer",
     .slots = {{{"latitude", "-120.5"}}}},
    {.code = "ice-gml-area-without-polygon",
     .rank = Rank::caution,
     .text = "an area of sea ice has no polygon, so the place of its ice is not known",
     .hint = "Copy or download the chart again"},
    {.code = "ice-gml-stages-too-many",
     .rank = Rank::caution,
     .text = "an area of sea ice has more than five stages of development, more than a chart can have",
     .hint = "Ask the producer of the chart"},
    {.code = "ice-gml-several-crs",
     .rank = Rank::caution,
     .text = "the areas of the S-411 chart are in {first} and {second}, but all must be in one coordinate "
             "reference system",
     .hint = "Ask its producer",
     .slots = {{{"first", "EPSG:4326"}, {"second", "EPSG:3995"}}}},
    {.code = "ice-gml-crs-unknown",
     .rank = Rank::caution,
     .text = "the coordinate reference system {crs} of the S-411 chart is not known",
     .hint = "Ask its producer for the chart in EPSG:4326",
     .slots = {{{"crs", "EPSG:1"}}}},
    {.code = "ice-gml-features-left-out",
     .rank = Rank::note,
     .text = "from the S-411 chart only areas of sea ice were read. These features were left out: {features}",
     .slots = {{{"features", "icebrg and lacice"}}}},
    {.code = "table-value-too-long",
     .rank = Rank::caution,
     .text = "a value of the table does not fit into its column and would be lost ({reason})",
     .hint = "Correct the value, or make the column a text column",
     .slots = {{{"reason", "Invalid content for record 3"}}}},
    {.code = "features-unreadable",
     .rank = Rank::caution,
     .text = "some features of the file cannot be read ({reason}). The file is damaged or holds texts that "
             "are too large for this program",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "not well-formed"}}}},
    {.code = "geopackage-with-code",
     .rank = Rank::caution,
     .text = "the GeoPackage holds {part}, which could run a stranger's code on this computer",
     .hint = "Save its layers into a new GeoPackage, for example with QGIS or ogr2ogr, and give the new file",
     .slots = {{{"part", "the trigger \"insert_all\""}}}},
    {.code = "geopackage-unreadable",
     .rank = Rank::caution,
     .text = "the GeoPackage cannot be read ({reason}). It is damaged or was cut short",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "database disk image is malformed"}}}},
    {.code = "geopackage-of-tiles",
     .rank = Rank::caution,
     .text = "the file holds a raster in tiles, but from a GeoPackage this program reads only points and "
             "polygons",
     .hint = "Convert a raster of depths with gdal_translate IN.gpkg OUT.tif, and give OUT.tif"},
    {.code = "vector-file-unreadable",
     .rank = Rank::caution,
     .text = "the file cannot be read ({reason}). It is damaged, was cut short, or lacks the files that "
             "belong to it (to a shapefile belong .shx and .dbf)",
     .hint = "Copy or download it again",
     .slots = {{{"reason", "no .shx"}}}},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_feature_message(const Given&... given) {
  return make_message<ingest_feature_kinds, code>(given...);
}

}  // namespace floeplan::messages
