#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a file is a GeoPackage: its SQLite header has the application id "GPKG" or, in versions up to 1.1,
/// "GP10" or "GP11".
/// Source  OGC 12-128, requirement 2; sqlite.org/fileformat.html, 1.3
[[nodiscard]] bool is_geopackage(std::string_view head);

/// Opens a file of features with one of GDAL's drivers, "GPKG" or "ESRI Shapefile".
/// Errors   damaged; a GeoPackage with views, computed columns or virtual tables other than R*Trees; no
///          features; a value that GDAL drops because it does not have its column's type
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_vector_file(const std::filesystem::path& file,
                                                                     const char* driver);

/// A shapefile and its sidecar files.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_shapefile(const std::filesystem::path& file);

/// Opens a GeoJSON file with one layer in longitude and latitude on WGS84 (RFC 7946).
/// Errors   damaged JSON; no features; another coordinate reference system (pre-RFC "crs" member)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file);

/// Name of the attribute with the time of a placemark's TimeStamp: a moment, a day, a month or a year.
inline constexpr const char* time_stamp = "when of the TimeStamp";
/// Name of the attribute with the names of the folders and the document around a placemark, outermost first.
inline constexpr const char* folder_names = "names of the folders around";
/// Names of the attributes with the narrowest time span of the folders and the document around a placemark.
inline constexpr const char* folder_begin = "begin of the folder's time";
inline constexpr const char* folder_end = "end of the folder's time";

/// Reads the placemarks of a KML document into one layer of features in longitude and latitude on WGS84.
/// Every attribute is a text as in the file. GDAL's own drivers are not used: they drop SimpleData without a
/// SimpleField and rewrite dates.
/// Names    Name and description; the names in ExtendedData; begin and end of the TimeSpan; `time_stamp`,
///          repeated as timestamp; `folder_names`, `folder_begin` and `folder_end`
/// Edges    heights are dropped; hidden placemarks count; lines, tracks and models become lines without
///          positions, which readers of points or polygons refuse; overlays are pictures and are ignored
/// Errors   no XML; no placemarks; coordinates that are not numbers; a link to another file, whose zones
///          would be missing; a folder that states the kind of its zones, because KML does not pass that on
///          to placemarks
/// Source   OGC KML 2.2 (07-147r2)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_kml(const std::filesystem::path& file);

/// Whether a document is an S-411 sea ice chart of any edition.
[[nodiscard]] bool is_s411(std::string_view head);

/// The areas of sea ice of an S-411 chart, with the corresponding attributes of SIGRID-3: CT from iceact, SA
/// to CD from icesod, POLY_TYPE. Other features are ignored, which `told` reports.
///  - iceact 1 to 4 are names for water with less than one tenth of ice, which producers number differently:
///    all of
///    them count as 02. A list of several totals counts as undetermined
///  - icesod is one stage or a list, "[87, 85, 99]"; 1 is ice free
/// Frame    as in srsName; EPSG:4326 if there is none, latitude first as the product requires
/// Source   JCOMM S-411 edition 1.1.0, clauses 4.6 (single polygons), 4.7 (reference systems) and 9.3 (encoding); the
///          lists, as the ice services write them: sigrid3.py of the WMO's repository S-41X-PS
/// Errors   no XML; edition 1.2 or later, whose areas have other names and do not state the order of their
///          axes; a latitude over 90 degrees; areas in several reference systems; no area of sea ice
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_s411(const std::filesystem::path& file,
                                                              Messages& told);

}  // namespace floeplan::ingest
