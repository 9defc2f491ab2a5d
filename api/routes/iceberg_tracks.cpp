#include <algorithm>

#include "api/codec/iceberg_feature.hpp"
#include "api/routes/feature_collection.hpp"
#include "api/routes/hand_made.hpp"
#include "storage/repository/iceberg_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::IcebergRepository;

bool meets(const repository::IcebergTrack& track, const FeatureQuery& query) {
  const auto wanted_name = query.filters.find("berg_id");
  if (wanted_name != query.filters.end() && wanted_name->second != track.berg_id) return false;
  if (query.span.from && track.fixes.back().time < *query.span.from) return false;
  if (query.span.to && track.fixes.front().time > *query.span.to) return false;
  return !query.area || std::any_of(track.fixes.begin(), track.fixes.end(),
                                    [&](const auto& fix) { return geo::contains(*query.area, fix.place); });
}

tl::expected<FeaturePage, codec::Problem> list(const Context& context, const FeatureQuery& query) {
  FeaturePage page;
  page.matched = 0;
  for (const auto& track : IcebergRepository{context.db}.tracks()) {
    if (!meets(track, query)) continue;
    ++*page.matched;
    if (track.first_row <= query.after) continue;
    if (std::ssize(page.features) == query.limit) continue;
    page.features.push_back(codec::iceberg_track_feature(track));
    if (std::ssize(page.features) == query.limit) page.next = track.first_row;
  }
  return page;
}

std::optional<json> find(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  if (!row) return std::nullopt;
  for (const auto& track : IcebergRepository{context.db}.tracks()) {
    if (track.first_row == *row) return codec::iceberg_track_feature(track);
  }
  return std::nullopt;
}

FeatureExtent extent(sqlite::Connection& db) { return extent_of_kind(db, repository::DatasetKind::icebergs); }

}  // namespace

FeatureCollection iceberg_track_collection() {
  return {.id = "iceberg-tracks",
          .title = "Tracks of icebergs",
          .description = "Where icebergs that were seen more than once have been, and when.",
          .schema = "IcebergTrack",
          .item_name = "track_id",
          .filters = {"berg_id"},
          .extent = extent,
          .list = list,
          .find = find};
}

}  // namespace floeplan::routes
