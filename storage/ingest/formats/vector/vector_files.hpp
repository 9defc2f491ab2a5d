#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a file is a GeoPackage, by the application's id in the head of an SQLite database, "GPKG" or, of version 1.1
/// and before, "GP10", "GP11".
/// Source  OGC 12-128, requirement 2; sqlite.org/fileformat.html, 1.3
[[nodiscard]] bool is_geopackage(std::string_view head);

/// Opens a file of features with one of GDAL's drivers, "GPKG" or "ESRI Shapefile".
/// Errors   damaged; a GeoPackage with views, computed columns or virtual tables but R*Trees; no features; a value that GDAL leaves out since it is none of its column's type
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_vector_file(const std::filesystem::path& file,
                                                                     const char* driver);

/// A shapefile and the files beside it that belong to it.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_shapefile(const std::filesystem::path& file);

/// Opens a GeoJSON file with one layer in longitude and latitude on WGS84 (RFC 7946).
/// Errors   damaged JSON; no features; another coordinate reference system (pre-RFC "crs" member)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_geojson(const std::filesystem::path& file);

/// The attribute that holds the time of a placemark's TimeStamp: a moment, a day, a month or a year.
inline constexpr const char* time_stamp = "when of the TimeStamp";
/// The attribute that holds the names of the folders and the document around a placemark, the outermost first.
inline constexpr const char* folder_names = "names of the folders around";
/// The attributes that hold the narrowest time span of the folders and the document around a placemark.
inline constexpr const char* folder_begin = "begin of the folder's time";
inline constexpr const char* folder_end = "end of the folder's time";

/// Reads the placemarks of a KML document into one layer of features in longitude and latitude on WGS84. Every
/// attribute is a text as the file writes it: GDAL's own drivers leave out SimpleData without a SimpleField, and spell
/// dates anew.
/// Names    Name and description; those of ExtendedData, of any kind; begin and end of the TimeSpan; `time_stamp`, which is
///          also in timestamp; `folder_names`, `folder_begin` and `folder_end`
/// Edges    heights are left out; hidden placemarks count; lines, tracks and models are lines without places, for readers
///          that refuse what is no point or polygon; overlays are pictures and left out
/// Errors   no XML; no placemarks; coordinates that are no numbers; a link to another file, whose zones would be missing;
///          a folder that states what a zone is, since KML hands that down to no placemark
/// Source   OGC KML 2.2 (07-147r2)
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_kml(const std::filesystem::path& file);

/// Whether a document is a chart of sea ice of the S-100 family, of whatever edition.
[[nodiscard]] bool is_s411(std::string_view head);

/// Areas of sea ice of an S-411 chart, with the attributes that SIGRID-3 has for the same: CT of iceact, SA to CD of
/// icesod, POLY_TYPE. What else the chart holds is left out and told in `told`.
///  - iceact 1 to 4 are names of water with less than one tenth of ice, which producers number differently: all of
///    them count as 02. A list of several totals counts as undetermined
///  - icesod is one stage or a list, "[87, 85, 99]"; 1 is ice free
/// Frame    of srsName; EPSG:4326 where there is none, latitude first as the product demands
/// Source   JCOMM S-411 edition 1.1.0, clauses 4.6 (single polygons), 4.7 (reference systems) and 9.3 (encoding); the
///          lists, as the ice services write them: sigrid3.py of the WMO's repository S-41X-PS
/// Errors   no XML; edition 1.2 and later, whose areas have other names and do not state the order of their axes; a
///          latitude over 90 degrees; areas in several reference systems; no area of sea ice
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_s411(const std::filesystem::path& file,
                                                              Messages& told);

}  // namespace floeplan::ingest
