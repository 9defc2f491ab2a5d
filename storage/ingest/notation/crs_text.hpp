#pragma once

#include <string>

class OGRSpatialReference;

namespace floeplan::ingest {

/// Reads a coordinate reference system from a text of a file or a user: a code of an authority (EPSG:3413, an
/// OGC URN or URL), a name as WGS84, WKT, PROJJSON, or a PROJ string of numbers and plain words. Other texts
/// are refused before they reach PROJ, which would open a file or address named in them: paths, URLs other
/// than OGC's names, dictionaries, pipelines and grids of datum shifts. The axes keep the order of the text.
/// Returns  whether the text was read; if not, `crs` is empty
/// Source   OGRSpatialReference::SetFromUserInput of GDAL 3.6; PROJ 9.1, "Cartographic projection"
[[nodiscard]] bool read_crs(const std::string& text, OGRSpatialReference& crs);

}  // namespace floeplan::ingest
