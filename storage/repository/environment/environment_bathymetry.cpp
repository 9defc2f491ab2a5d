#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/messages/data_messages.hpp"
#include "storage/repository/datasets/resampled.hpp"
#include "storage/repository/environment/environment_draft.hpp"
#include "storage/repository/environment/environment_parts.hpp"
#include "storage/repository/fields/bathymetry_mosaic.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::repository {
namespace {

constexpr core::Metres coarse_spacing{5000.0};
/// Limit of a combined grid: two arrays of 4 bytes per node, and the cells while it is filled, about 50 MB.
constexpr std::size_t most_mosaic_nodes = 2'000'000;

std::string in_metres_or_km(core::Metres length) {
  return length.value < 1000.0 ? std::to_string(std::lround(length.value)) + " m"
                               : std::to_string(std::lround(length.value / 1000.0)) + " km";
}

/// A dataset and the spacing of its nodes.
struct Layer {
  Dataset dataset;
  core::Metres spacing;
};

std::vector<Layer> layers_of(const EnvironmentDraft& draft, const std::vector<Dataset>& found) {
  std::vector<Layer> layers;
  for (const Dataset& dataset : found)
    if (const auto shape = FieldRepository{draft.db}.shape(dataset.id))
      layers.push_back({dataset, shape->grid.spacing()});
  if (draft.query.bathymetry.how != DatasetChoice::How::named)
    std::ranges::stable_sort(layers, {}, [](const Layer& layer) {
      return std::pair{layer.spacing, was_resampled(layer.dataset.warnings)};
    });
  return layers;
}

/// Whether there is a depth at each of 65 x 65 places in the area.
bool covers(const ocean::Bathymetry& bathymetry, const geo::BoundingBox& area) {
  return holds_all_over(area, 64, [&](geo::LonLat place) { return bathymetry.depth(place).has_value(); });
}

void adopt_bathymetry(EnvironmentDraft& draft, ocean::Bathymetry bathymetry,
                      const std::vector<Dataset>& used) {
  const core::Metres spacing = bathymetry.grid().spacing();
  std::string names;
  for (const Dataset& dataset : used) names += (names.empty() ? "" : ", then ") + title(dataset);
  if (used.size() > 1)
    draft.tell(messages::data_message<"bathymetry-joined">(names, in_metres_or_km(spacing)));
  if (spacing > coarse_spacing)
    draft.tell(messages::data_message<"bathymetry-coarse">(names, in_metres_or_km(spacing)));
  draft.environment.bathymetry = std::make_shared<const ocean::Bathymetry>(std::move(bathymetry));
  for (const Dataset& dataset : used) draft.cite(dataset);
}

}  // namespace

void add_bathymetry(EnvironmentDraft& draft) {
  const EnvironmentQuery& query = draft.query;
  const auto found =
      candidates(draft.stored, DatasetKind::bathymetry, query.bathymetry, query.area, draft.violations);
  const FieldRepository fields{draft.db, draft.reading.stop};
  std::optional<ocean::Bathymetry> alone;  // the first layer, as long as no other is needed
  std::optional<BathymetryMosaic> mosaic;
  std::vector<Dataset> used;
  const std::vector<Layer> layers = layers_of(draft, found);
  for (const Layer& layer : layers) {
    auto bathymetry = fields.load_bathymetry(layer.dataset.id, query.area);
    if (!bathymetry) continue;
    if (!alone) {
      alone = std::move(bathymetry);
      used.push_back(layer.dataset);
      if (layers.size() == 1 || covers(*alone, query.area)) break;
      continue;
    }
    if (!mosaic) {
      const auto finest = std::ranges::min(layers, {}, &Layer::spacing).spacing;
      mosaic.emplace(query.area, finest, most_mosaic_nodes);
      mosaic->add(*alone);
    }
    if (mosaic->add(*bathymetry)) used.push_back(layer.dataset);
    if (mosaic->is_complete()) break;
  }
  if (alone) return adopt_bathymetry(draft, used.size() > 1 ? mosaic->bathymetry() : std::move(*alone), used);

  const bool named = query.bathymetry.how == DatasetChoice::How::named;
  if (named && !found.empty()) draft.refuse<"no-node-near">(DatasetKind::bathymetry, title(found.front()));
  if (!named)
    tell_of_gap(draft, query.bathymetry, messages::data_message<"bathymetry-left-out">(),
                messages::data_message<"bathymetry-missing">(geo::bounds_text(named_area(query))));
}

}  // namespace floeplan::repository
