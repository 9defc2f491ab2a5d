#include "storage/ingest/readers/bathymetry/raster_crs.hpp"

#include <cpl_minixml.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/messages/ingest_depth_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"
#include "storage/ingest/notation/crs_text.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// Plain text grids often have no CRS. They are probably in degrees if they lie within the globe and the step
/// is a whole number of arc seconds below a degree; steps in metres hardly ever are.
bool looks_like_degrees(const RasterTransform& t, int columns, int rows) {
  const double east = t[0] + t[1] * columns;
  const double south = t[3] + t[5] * rows;
  const bool on_the_globe = std::min(t[0], east) >= -180.5 && std::max(t[0], east) <= 360.5 &&
                            std::max(std::abs(t[3]), std::abs(south)) <= 90.5;
  const auto whole_arc_seconds = [](double step) {
    const double arc_seconds = std::abs(step) * 3600.0;
    return std::abs(step) < 0.9999 && std::abs(arc_seconds - std::round(arc_seconds)) < 1e-3 * arc_seconds &&
           std::round(arc_seconds) >= 1.0;
  };
  return on_the_globe && whole_arc_seconds(t[1]) && whole_arc_seconds(t[5]);
}

/// The horizontal reference system that the metadata of a BAG names only by its code; GDAL reads only full
/// definitions.
std::optional<OGRSpatialReference> crs_named_in_bag(GDALDataset& dataset) {
  char** const description = dataset.GetMetadata("xml:BAG");
  if (description == nullptr || *description == nullptr) return std::nullopt;
  const GdalMessages messages;
  const CPLXMLTreeCloser root{CPLParseXMLString(*description)};
  if (root.get() == nullptr) return std::nullopt;
  CPLStripXMLNamespace(root.get(), nullptr, TRUE);
  const CPLXMLNode* const system = CPLSearchXMLNode(root.get(), "=referenceSystemInfo");
  const std::string identifier = "MD_ReferenceSystem.referenceSystemIdentifier.RS_Identifier.";
  const std::string space = CPLGetXMLValue(system, (identifier + "codeSpace.CharacterString").c_str(), "");
  const auto code = parse_number(CPLGetXMLValue(system, (identifier + "code.CharacterString").c_str(), ""));
  OGRSpatialReference crs;
  if (lower(trimmed(space)) != "epsg" || !code || !(*code >= 1.0 && *code <= 1e6)) return std::nullopt;
  if (crs.importFromEPSG(static_cast<int>(*code)) != OGRERR_NONE) return std::nullopt;
  if (crs.IsProjected() == 0 && crs.IsGeographic() == 0) return std::nullopt;
  return crs;
}

std::string wkt_of(const OGRSpatialReference& crs) {
  char* wkt = nullptr;
  const char* const format[] = {"FORMAT=WKT2_2018", nullptr};
  crs.exportToWkt(&wkt, format);
  std::string text = wkt == nullptr ? "" : wkt;
  CPLFree(wkt);
  return text;
}

}  // namespace

Checked<OGRSpatialReference> crs_of_raster(GDALDataset& dataset, std::string_view driver,
                                           const IngestOptions& options, Messages& warnings) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (const OGRSpatialReference* stated = dataset.GetSpatialRef()) {
    crs = *stated;
    if (driver == "BAG" && crs.IsVertical() != 0 && contains_any(wkt_of(crs), {"\"depth\",down"}) &&
        !options.positive)
      return refuse(messages::ingest_depth_message<"bag-counts-downwards">());
    if (crs.IsCompound() != 0) crs.StripVertical();
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
  }
  if (const auto named = driver == "BAG" ? crs_named_in_bag(dataset) : std::nullopt) {
    crs = *named;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
  }
  if (options.crs) {
    if (read_crs(*options.crs, crs)) {
      crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      return crs;
    }
    return refuse(messages::ingest_depth_message<"crs-unknown">(*options.crs));
  }
  const bool plain_text = driver == "XYZ" || driver == "AAIGrid" || driver == depth_table;
  RasterTransform transform{};
  dataset.GetGeoTransform(transform.data());
  if (plain_text && looks_like_degrees(transform, dataset.GetRasterXSize(), dataset.GetRasterYSize())) {
    warnings.push_back(messages::ingest_depth_message<"crs-taken-as-degrees">());
    crs.SetWellKnownGeogCS("WGS84");
    return crs;
  }
  return refuse(messages::ingest_depth_message<"crs-missing">());
}

}  // namespace floeplan::ingest
