#include "api/codec/features/iceberg_feature.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/hand_made.hpp"
#include "storage/repository/features/iceberg_track_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::IcebergTrackRepository;

tl::expected<FeaturePage, problems::Problem> list_iceberg_tracks(const Context& context,
                                                                 const FeatureQuery& query) {
  repository::TrackFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  if (const auto berg = query.filters.find("berg_id"); berg != query.filters.end())
    filter.berg_id = berg->second;
  const IcebergTrackRepository tracks{context.db};
  const auto found = tracks.list(filter, query.after, query.limit);
  FeaturePage page;
  page.matched = tracks.count(filter);
  for (const auto& track : found.tracks) page.features.push_back(codec::iceberg_track_feature(track));
  if (found.more) page.next = found.tracks.back().first_row;
  return page;
}

std::optional<json> find_iceberg_track(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  const auto track = row ? IcebergTrackRepository{context.db}.find(*row) : std::nullopt;
  return track ? std::optional{codec::iceberg_track_feature(*track)} : std::nullopt;
}

FeatureExtent iceberg_track_extent(sql::Connection& db) {
  return extent_of_kind(db, repository::DatasetKind::icebergs);
}

}  // namespace

FeatureCollection iceberg_track_collection() {
  return {.id = "iceberg-tracks",
          .title = "Tracks of icebergs",
          .description = "Where icebergs that were seen more than once have been, and when.",
          .schema = "IcebergTrack",
          .item_name = "track_id",
          .filters = {"berg_id"},
          .extent = iceberg_track_extent,
          .list = list_iceberg_tracks,
          .find = find_iceberg_track};
}

}  // namespace floeplan::routes
