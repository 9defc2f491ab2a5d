#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <set>

#include "engine/core/utc_text.hpp"
#include "engine/messages/ingest_ice_messages.hpp"
#include "storage/ingest/common/fault_report.hpp"
#include "storage/ingest/formats/vector/feature_texts.hpp"
#include "storage/ingest/formats/vector/polygon_shapes.hpp"
#include "storage/ingest/notation/text.hpp"
#include "storage/ingest/readers/ice/chart_time.hpp"
#include "storage/ingest/readers/ice/ice_raster.hpp"
#include "storage/ingest/readers/ice/ice_readers.hpp"
#include "storage/ingest/readers/zones/feature_kind.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr auto thickness_names = std::to_array<std::string_view>({"thicknessm", "thickness"});
constexpr double thickest_level_m = 20.0;  // greatest thickness of sea ice that froze in place

/// The time of the chart, with a warning if only its name states it.
Checked<core::UtcTime> chart_time(const std::filesystem::path& file, const IngestOptions& options,
                                  Messages& warnings) {
  if (options.time) return *options.time;
  std::optional<core::UtcTime> time = time_in_name(file.stem().string());
  if (!time && options.archive) time = time_in_name(*options.archive);
  if (!time) return refuse(messages::ingest_ice_message<"chart-time-missing">());
  warnings.push_back(messages::ingest_ice_message<"chart-time-from-name">(*time));
  return *time;
}

/// Ice of a polygon without codes; its concentration is 1.
Checked<std::optional<IceOfPolygon>> plain_ice(const OGRFeature& feature) {
  if (meaning_of(feature) == PolygonMeaning::ice_shelf) return IceOfPolygon{1.0, ice_shelf_thickness_m};
  const auto text = text_of_feature(feature, thickness_names);
  if (!text) return IceOfPolygon{1.0, std::nullopt};
  const auto thickness_m = parse_number(*text);
  if (!thickness_m || *thickness_m < 0.0 || *thickness_m > thickest_level_m)
    return refuse(messages::ingest_ice_message<"ice-thickness-not-a-number">(*text));
  return IceOfPolygon{1.0, thickness_m};
}

/// The polygons collected so far, and all faults found.
struct ChartGathering {
  std::vector<IcePolygon> polygons;
  std::vector<repository::ChartPolygon> outlines;  // outlines of polygons with egg codes
  Messages faults;
  bool coded{false};
  bool uncoded{false};
};

/// Adds the outlines of a polygon for drawing. A polygon whose outline is not a valid area is not drawn; its
/// ice is still on the grid.
void gather_outlines(ChartGathering& all, const OGRFeature& feature, const PolygonShapes& shapes) {
  auto outlines = shapes.polygons(feature.GetGeometryRef());
  if (!outlines) return;
  const std::vector<repository::IceCode> codes = egg_code(feature);
  for (geo::Polygon& outline : *outlines) all.outlines.push_back({codes, std::move(outline)});
}

void gather_ice(ChartGathering& all, const OGRFeature& feature, const std::string& label,
                OGRSpatialReference& crs, const PolygonShapes& shapes) {
  const OGRGeometry* const geometry = feature.GetGeometryRef();
  const bool coded = states_ice_codes(feature);
  (coded ? all.coded : all.uncoded) = true;
  const auto ice = coded ? read_ice_codes(feature) : plain_ice(feature);
  if (!ice) return all.faults.push_back(about(label, ice.error().front()));
  if (!*ice || geometry == nullptr) return;  // land, or an area without observation
  if (OGR_GT_IsSubClassOf(wkbFlatten(geometry->getGeometryType()), wkbSurface) == 0 &&
      OGR_GT_IsSubClassOf(wkbFlatten(geometry->getGeometryType()), wkbMultiSurface) == 0)
    return all.faults.push_back(about(label, messages::ingest_ice_message<"ice-not-a-polygon">()));
  if (coded) gather_outlines(all, feature, shapes);
  std::unique_ptr<OGRGeometry> area{geometry->getLinearGeometry()};
  area->assignSpatialReference(&crs);
  all.polygons.push_back({std::move(area), **ice});
}

Checked<ChartGathering> gather_polygons(GDALDataset& dataset, const IngestOptions& options) {
  ChartGathering all;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    if (layer->GetFeatureCount() == 0) continue;
    const auto crs = crs_of(*layer, options.crs);
    if (!crs) return refuse(crs.error());
    const auto shapes = PolygonShapes::in(*crs);
    if (!shapes) return refuse(shapes.error());
    const std::unique_ptr<OGRSpatialReference, void (*)(OGRSpatialReference*)> counted{
        // shared, because geometries refer to it
        crs->Clone(), [](OGRSpatialReference* reference) { reference->Release(); }};
    int number_of_feature = 0;
    layer->ResetReading();
    for (const auto& feature : *layer)
      gather_ice(all, *feature, "polygon " + std::to_string(++number_of_feature), *counted, *shapes);
  }
  if (all.coded && all.uncoded) all.faults.push_back(messages::ingest_ice_message<"ice-codes-mixed">());
  if (all.polygons.empty() && all.faults.empty())
    all.faults.push_back(messages::ingest_ice_message<"chart-of-land-only">());
  return all;
}

}  // namespace

Checked<PreparedDataset> read_ice_polygons(GDALDataset& dataset, const std::filesystem::path& file,
                                           const IngestOptions& options) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::ice;
  const auto time = chart_time(file, options, data.warnings);
  if (!time) return refuse(time.error());
  auto gathered = gather_polygons(dataset, options);
  if (!gathered) return refuse(gathered.error());
  if (!gathered->faults.empty()) return refuse(report_of(std::move(gathered->faults)));
  const bool coded = gathered->coded;
  auto raster = lay_on_grid(std::move(gathered->polygons));
  if (!raster) return refuse(raster.error());

  data.warnings.push_back(coded ? messages::ingest_ice_message<"upper-ends-stored">()
                                : messages::ingest_ice_message<"whole-polygons-are-ice">());
  data.variables = coded ? std::vector<std::string>{"CT", "SA"} : std::vector<std::string>{"ice"};
  data.bounds = raster->grid.bounds();
  data.rows_accepted = static_cast<std::int64_t>(raster->grid.size());
  data.time_start = *time;
  data.time_end = *time;
  data.write = [raster = std::move(*raster), outlines = std::move(gathered->outlines), time = *time](
                   sql::Connection& db, const repository::DatasetId& id) -> Checked<void> {
    repository::FieldRepository fields{db};
    fields.create(id, {raster.grid, std::nullopt, ocean::Axis{{core::unix_seconds(time)}}});
    fields.write_slice(id, "concentration", 0, 0, raster.concentration);
    fields.write_slice(id, "thickness_m", 0, 0, raster.thickness_m);
    repository::IceChartRepository{db}.insert(id, outlines);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
