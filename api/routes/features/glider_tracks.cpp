#include "api/codec/features/glider_track_feature.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/hand_made.hpp"
#include "storage/repository/features/glider_track_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::GliderTrackRepository;

tl::expected<FeaturePage, problems::Problem> list_glider_tracks(const Context& context,
                                                                const FeatureQuery& query) {
  repository::GliderTrackFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  if (const auto glider = query.filters.find("glider"); glider != query.filters.end())
    filter.glider = glider->second;
  const GliderTrackRepository tracks{context.db};
  const auto found = tracks.list(filter, query.after, query.limit);
  FeaturePage page;
  page.matched = tracks.count(filter);
  for (const auto& track : found.tracks) page.features.push_back(codec::glider_track_feature(track));
  if (found.more) page.next = found.tracks.back().row;
  return page;
}

std::optional<json> find_glider_track(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  const auto track = row ? GliderTrackRepository{context.db}.find(*row) : std::nullopt;
  return track ? std::optional{codec::glider_track_feature(*track)} : std::nullopt;
}

FeatureExtent glider_track_extent(sql::Connection& db) {
  return extent_of_kind(db, repository::DatasetKind::glider_tracks);
}

}  // namespace

FeatureCollection glider_track_collection() {
  return {.id = "glider-tracks",
          .title = "Tracks of gliders",
          .description = "Where gliders have been, how deep, and the depth-averaged currents that they met.",
          .schema = "GliderTrack",
          .item_name = "track_id",
          .filters = {"glider"},
          .extent = glider_track_extent,
          .list = list_glider_tracks,
          .find = find_glider_track};
}

}  // namespace floeplan::routes
