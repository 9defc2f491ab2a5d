#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geo/polygon.hpp"
#include "engine/geo/ring_turns.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/formats/vector/polygon_shapes.hpp"
#include "storage/ingest/readers/coastline/coastline_readers.hpp"
#include "storage/ingest/readers/zones/feature_kind.hpp"
#include "storage/repository/features/coastline_repository.hpp"

namespace floeplan::ingest {
namespace {

struct Gathering {
  std::vector<geo::Polygon> land;
  bool shelves{false};
  bool others{false};
};

/// Makes an outline around a pole include the pole: such land is Antarctica, or ice around the north pole.
/// Returns why the inside of the outline is uncertain; empty if it is not.
std::string close_over_pole(geo::Polygon& polygon) {
  constexpr double polar_lat_deg = 60.0;
  const bool polar = std::ranges::all_of(
      polygon.outer, [](geo::LonLat corner) { return std::abs(corner.lat_deg) >= polar_lat_deg; });
  if (polar)
    if (auto closed = closed_over_pole(polygon.outer)) polygon.outer = std::move(*closed);
  return geo::doubt_in_turns(polygon);
}

std::string feature_name(int number) { return "feature " + std::to_string(number); }

Checked<void> gather_land(Gathering& all, OGRLayer& layer, const IngestOptions& options) {
  const auto crs = crs_of(layer, options.crs);
  if (!crs) return refuse(crs.error());
  const auto shapes = PolygonShapes::in(*crs);
  if (!shapes) return refuse(shapes.error());
  int number_of_feature = 0;
  layer.ResetReading();
  for (const auto& feature : layer) {
    ++number_of_feature;
    auto polygons = shapes->polygons(feature->GetGeometryRef());
    if (!polygons)
      return refuse(about(feature_name(number_of_feature),
                          messages::ingest_area_message<"land-unusable">(reason_of(polygons.error()))));
    for (geo::Polygon& polygon : *polygons) {
      if (const std::string doubt = close_over_pole(polygon); !doubt.empty())
        return refuse(about(feature_name(number_of_feature),
                            messages::ingest_area_message<"land-unusable">("it " + doubt)));
      all.land.push_back(std::move(polygon));
    }
    (meaning_of(*feature) == PolygonMeaning::ice_shelf ? all.shelves : all.others) = true;
  }
  return {};
}

}  // namespace

Checked<PreparedDataset> read_coastline(GDALDataset& dataset, const IngestOptions& options) {
  Gathering all;
  for (OGRLayer* const layer : dataset.GetLayers()) {
    if (layer->GetFeatureCount() == 0) continue;
    if (const auto gathered = gather_land(all, *layer, options); !gathered) return refuse(gathered.error());
  }

  std::vector<geo::LonLat> corners;
  for (const geo::Polygon& polygon : all.land)
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
  PreparedDataset data;
  data.kind = repository::DatasetKind::coastline;
  if (all.others) data.variables.emplace_back("land");
  if (all.shelves) data.variables.emplace_back(repository::ice_shelves_alone);
  if (all.shelves) data.warnings.push_back(messages::ingest_area_message<"ice-shelves-are-land">());
  data.bounds = geo::bounding_box(corners);
  for (const geo::Polygon& polygon : all.land)
    data.bounds = geo::united(data.bounds, geo::bounding_box(polygon));
  data.rows_accepted = static_cast<std::int64_t>(all.land.size());
  data.write = [land = std::move(all.land)](sql::Connection& db,
                                            const repository::DatasetId& id) -> Checked<void> {
    repository::CoastlineRepository{db}.insert(id, land);
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
