#pragma once

#include <string>

class OGRSpatialReference;

namespace floeplan::ingest {

/// Reads a coordinate reference system from a text that a file or a user gives: a code of an authority (EPSG:3413, a URN
/// or URL of OGC), a name as WGS84, WKT, PROJJSON, or a PROJ string of numbers and plain words. No other text
/// gets as far as the library, which would open the file or the address that it names: no path, no URL but OGC's names,
/// no dictionary, no pipeline and no grid of datum shifts. Axes keep the order that the text gives them.
/// Returns  whether the text is one and is known; if not, `crs` is empty
/// Source   OGRSpatialReference::SetFromUserInput of GDAL 3.6; PROJ 9.1, "Cartographic projection"
[[nodiscard]] bool read_crs(const std::string& text, OGRSpatialReference& crs);

}  // namespace floeplan::ingest
