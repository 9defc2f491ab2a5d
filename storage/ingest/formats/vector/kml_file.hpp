#pragma once

#include <filesystem>
#include <memory>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

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

}  // namespace floeplan::ingest
