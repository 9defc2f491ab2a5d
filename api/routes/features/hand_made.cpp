#include "api/routes/features/hand_made.hpp"

#include <algorithm>
#include <stdexcept>

#include "api/codec/bytes/sha256.hpp"
#include "api/codec/features/iceberg_feature.hpp"
#include "api/codec/features/zone_feature.hpp"
#include "engine/core/version.hpp"
#include "engine/geo/united_boxes.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/zone_repository.hpp"

namespace floeplan::routes {
namespace {

using repository::Dataset;
using repository::DatasetId;
using repository::DatasetKind;

constexpr int all_of_them = 1'000'000;

void widen(std::optional<core::UtcTime>& from, std::optional<core::UtcTime>& to, core::UtcTime time) {
  from = from ? std::min(*from, time) : time;
  to = to ? std::max(*to, time) : time;
}

/// The content of the dataset, as text and as a summary.
struct Contents {
  std::string text;
  std::vector<geo::LonLat> places;
  std::vector<geo::BoundingBox> areas;  // boxes of areas, whose edges may extend beyond their corners
  std::int64_t rows{};
  std::optional<core::UtcTime> from;
  std::optional<core::UtcTime> to;
};

Contents contents_of(sql::Connection& db, const DatasetId& id, DatasetKind kind) {
  Contents contents;
  if (kind == DatasetKind::icebergs) {
    repository::SightingFilter filter;
    filter.dataset = id;
    for (const auto& sighting : repository::IcebergRepository{db}.list(filter, 0, all_of_them)) {
      contents.text += codec::iceberg_feature(sighting).dump() + '\n';
      contents.places.push_back(sighting.iceberg.place);
      widen(contents.from, contents.to, sighting.iceberg.observed);
      ++contents.rows;
    }
    return contents;
  }
  repository::ZoneFilter filter;
  filter.dataset = id;
  for (const auto& stored : repository::ZoneRepository{db}.list(filter, 0, all_of_them)) {
    contents.text += codec::zone_feature(stored).dump() + '\n';
    const auto& outline = stored.zone.area.outer;
    contents.places.insert(contents.places.end(), outline.begin(), outline.end());
    contents.areas.push_back(geo::bounding_box(stored.zone.area));
    ++contents.rows;
  }
  return contents;
}

}  // namespace

DatasetId hand_made_dataset(sql::Connection& db, DatasetKind kind, core::UtcTime now) {
  const DatasetId id = repository::hand_made_id(kind);
  repository::DatasetRepository datasets{db};
  if (datasets.find(id)) return id;
  Dataset dataset;
  dataset.id = id;
  dataset.kind = kind;
  dataset.name = "Manual entries";
  dataset.provenance.file_name = "none";
  dataset.provenance.ingested = now;
  dataset.provenance.tool_version = core::program_version();
  datasets.insert(dataset);
  return id;
}

void refresh_hand_made(sql::Connection& db, DatasetKind kind, core::UtcTime now) {
  const DatasetId id = repository::hand_made_id(kind);
  repository::DatasetRepository datasets{db};
  auto dataset = datasets.find(id);
  if (!dataset) return;
  const Contents contents = contents_of(db, id, kind);
  if (contents.rows == 0) {
    datasets.remove(id);
    return;
  }
  dataset->bounds = geo::bounding_box(contents.places);
  for (const geo::BoundingBox& area : contents.areas) dataset->bounds = geo::united(dataset->bounds, area);
  dataset->time_start = contents.from;
  dataset->time_end = contents.to;
  dataset->rows_accepted = contents.rows;
  dataset->provenance.sha256 = codec::sha256(contents.text);
  dataset->provenance.file_size_bytes = std::ssize(contents.text);
  dataset->provenance.ingested = now;
  datasets.update(*dataset);
}

std::string objection_to_editing(const DatasetId& dataset) {
  if (dataset == repository::hand_made_id(DatasetKind::icebergs) ||
      dataset == repository::hand_made_id(DatasetKind::zones))
    return {};
  return "It is part of the dataset " + dataset.value +
         ", which holds what a file says; remove the dataset, or ingest a newer file.";
}

FeatureExtent extent_of_kind(sql::Connection& db, DatasetKind kind) {
  FeatureExtent extent;
  std::vector<geo::BoundingBox> boxes;
  for (const Dataset& dataset : repository::DatasetRepository{db}.list()) {
    if (dataset.kind != kind) continue;
    boxes.push_back(dataset.bounds);
    if (dataset.time_start) widen(extent.from, extent.to, *dataset.time_start);
    if (dataset.time_end) widen(extent.from, extent.to, *dataset.time_end);
  }
  if (!boxes.empty()) extent.area = geo::united(boxes);
  return extent;
}

}  // namespace floeplan::routes
