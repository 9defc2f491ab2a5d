#include "api/codec/features/zone_feature.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/hand_made.hpp"
#include "storage/repository/features/zone_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;
using repository::ZoneRepository;

tl::expected<FeaturePage, problems::Problem> list_zones(const Context& context, const FeatureQuery& query) {
  repository::ZoneFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  if (const auto found = query.filters.find("kind"); found != query.filters.end())
    filter.kind = found->second;
  if (const auto found = query.filters.find("name"); found != query.filters.end())
    filter.name = found->second;
  const ZoneRepository zones{context.db};
  FeaturePage page;
  page.matched = zones.count(filter);
  const auto stored = zones.list(filter, query.after, query.limit);
  for (const auto& zone : stored) page.features.push_back(codec::zone_feature(zone));
  if (std::ssize(stored) == query.limit) page.next = stored.back().row;
  return page;
}

std::optional<json> find_zone(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  const auto zone = row ? ZoneRepository{context.db}.find(*row) : std::nullopt;
  return zone ? std::optional{codec::zone_feature(*zone)} : std::nullopt;
}

FeatureExtent zone_extent(sql::Connection& db) { return extent_of_kind(db, DatasetKind::zones); }

tl::expected<std::string, core::Violations> create(const Context& context, const json& feature,
                                                   core::UtcTime now) {
  const auto zone = codec::parse_zone_feature(feature);
  if (!zone) return tl::unexpected(zone.error());
  const auto dataset = hand_made_dataset(context.db, DatasetKind::zones, now);
  const std::int64_t row = ZoneRepository{context.db}.add(dataset, *zone);
  refresh_hand_made(context.db, DatasetKind::zones, now);
  return std::to_string(row);
}

tl::expected<void, core::Violations> replace(const Context& context, const std::string& id,
                                             const json& feature, core::UtcTime now) {
  const auto zone = codec::parse_zone_feature(feature);
  if (!zone) return tl::unexpected(zone.error());
  ZoneRepository{context.db}.replace(key_of(id).value(), *zone);
  refresh_hand_made(context.db, DatasetKind::zones, now);
  return {};
}

void remove(const Context& context, const std::string& id, core::UtcTime now) {
  ZoneRepository{context.db}.remove(key_of(id).value());
  refresh_hand_made(context.db, DatasetKind::zones, now);
}

std::string objection(const Context& context, const std::string& id) {
  return objection_to_editing(ZoneRepository{context.db}.find(key_of(id).value())->dataset);
}

}  // namespace

FeatureCollection zone_collection() {
  return {.id = "nogo-zones",
          .title = "Zones",
          .description = "Areas that vehicles keep out of, or stay in, for some depths and some time.",
          .schema = "Zone",
          .item_name = "zone_id",
          .filters = {"kind", "name"},
          .extent = zone_extent,
          .list = list_zones,
          .find = find_zone,
          .editing = FeatureEditing{create, replace, remove, objection}};
}

}  // namespace floeplan::routes
