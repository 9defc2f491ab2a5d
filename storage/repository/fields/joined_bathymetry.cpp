#include "storage/repository/fields/joined_bathymetry.hpp"

#include <algorithm>
#include <utility>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/resampled.hpp"
#include "storage/repository/fields/bathymetry_mosaic.hpp"
#include "storage/repository/fields/field_overviews.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::repository {
namespace {

struct DepthLayer {
  DatasetId id;
  core::Metres spacing;
  bool resampled{};  // by an older version
};

std::vector<DepthLayer> depth_layers_in(sql::Connection& db, const geo::BoundingBox& area) {
  const FieldRepository fields{db};
  std::vector<DepthLayer> layers;
  for (const Dataset& dataset : DatasetRepository{db}.list()) {
    if (dataset.kind != DatasetKind::bathymetry || !geo::intersects(dataset.bounds, area)) continue;
    if (const auto shape = fields.shape(dataset.id))
      layers.push_back({dataset.id, shape->grid.spacing(), was_resampled(dataset.warnings)});
  }
  std::ranges::stable_sort(layers, {},
                           [](const DepthLayer& layer) { return std::pair{layer.spacing, layer.resampled}; });
  return layers;
}

}  // namespace

std::optional<JoinedBathymetry> joined_bathymetry(sql::Connection& db, const geo::BoundingBox& area,
                                                  std::size_t most_nodes) {
  const std::vector<DepthLayer> layers = depth_layers_in(db, area);
  if (layers.empty()) return std::nullopt;
  BathymetryMosaic mosaic{area, layers.front().spacing, most_nodes};
  std::vector<DatasetId> used;
  for (const DepthLayer& layer : layers) {
    auto depths = FieldOverviews{db}.bathymetry(layer.id, area, FieldOverviews::plenty);
    if (!depths) continue;
    const bool alone = layers.size() == 1 && depths->grid().size() <= most_nodes;
    if (alone) return JoinedBathymetry{std::move(*depths), {layer.id}};
    if (mosaic.add(*depths)) used.push_back(layer.id);
    if (mosaic.is_complete()) break;
  }
  if (used.empty()) return std::nullopt;
  return JoinedBathymetry{mosaic.bathymetry(), std::move(used)};
}

}  // namespace floeplan::repository
