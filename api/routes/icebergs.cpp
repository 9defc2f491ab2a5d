#include <algorithm>

#include "api/codec/iceberg_feature.hpp"
#include "api/routes/feature_collection.hpp"
#include "api/routes/hand_made.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/environment_loader.hpp"
#include "storage/repository/iceberg_repository.hpp"
#include "storage/repository/joined_sightings.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;
using repository::IcebergRepository;
using repository::StoredSighting;

constexpr geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};

/// The newest sighting of each berg over the datasets asked for, by ascending row.
std::vector<StoredSighting> latest_of_each(sqlite::Connection& db, const repository::SightingFilter& filter,
                                           core::UtcTime as_of) {
  std::vector<repository::Dataset> datasets;
  for (const auto& dataset : repository::DatasetRepository{db}.list())
    if (dataset.kind == DatasetKind::icebergs && (!filter.dataset || dataset.id == *filter.dataset))
      datasets.push_back(dataset);
  auto result = repository::joined_sightings(db, datasets, filter.area.value_or(whole_world), as_of,
                                             as_of - repository::oldest_sighting_used(as_of));
  std::erase_if(result, [&](const StoredSighting& sighting) {
    return filter.berg_id && sighting.iceberg.id != *filter.berg_id;
  });
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  return result;
}

std::vector<StoredSighting> page_of(const std::vector<StoredSighting>& all, std::int64_t after, int limit) {
  std::vector<StoredSighting> page;
  for (const auto& sighting : all) {
    if (sighting.row > after && std::ssize(page) < limit) page.push_back(sighting);
  }
  return page;
}

std::optional<std::string> filter_of(const FeatureQuery& query, const std::string& name) {
  const auto found = query.filters.find(name);
  return found == query.filters.end() ? std::nullopt : std::optional{found->second};
}

tl::expected<bool, codec::Problem> read_latest(const FeatureQuery& query) {
  const std::string latest = filter_of(query, "latest").value_or("false");
  core::Violations violations;
  if (latest != "true" && latest != "false")
    violations.push_back({"?latest", "the query parameter \"latest\" must be true or false"});
  if (latest == "true" && !query.span.to)
    violations.push_back(
        {"?datetime",
         "the query parameter \"datetime\" is required: with latest=true, the moment to look at"});
  if (!violations.empty())
    return tl::unexpected(codec::Problem{400, "invalid-request", "Invalid request",
                                         "The request has faults; each is listed under \"errors\".",
                                         std::move(violations)});
  return latest == "true";
}

tl::expected<FeaturePage, codec::Problem> list(const Context& context, const FeatureQuery& query) {
  const auto latest = read_latest(query);
  if (!latest) return tl::unexpected(latest.error());
  repository::SightingFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  filter.berg_id = filter_of(query, "berg_id");
  if (const auto dataset = filter_of(query, "dataset")) {
    filter.dataset = repository::DatasetId{*dataset};
    if (!repository::DatasetRepository{context.db}.find(*filter.dataset))
      return tl::unexpected(
          codec::Problem{404, "unknown-dataset", "Not found", "No dataset has the id " + *dataset + ".", {}});
  }
  const IcebergRepository icebergs{context.db};
  FeaturePage page;
  std::vector<StoredSighting> sightings;
  if (*latest) {
    const auto all = latest_of_each(context.db, filter, query.span.to.value_or(query.now));
    sightings = page_of(all, query.after, query.limit);
    page.matched = std::ssize(all);
  } else {
    sightings = icebergs.list(filter, query.after, query.limit);
    page.matched = icebergs.count(filter);
  }
  for (const auto& sighting : sightings) page.features.push_back(codec::iceberg_feature(sighting));
  if (std::ssize(sightings) == query.limit) page.next = sightings.back().row;
  return page;
}

std::optional<json> find(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  const auto sighting = row ? IcebergRepository{context.db}.find(*row) : std::nullopt;
  return sighting ? std::optional{codec::iceberg_feature(*sighting)} : std::nullopt;
}

FeatureExtent extent(sqlite::Connection& db) { return extent_of_kind(db, DatasetKind::icebergs); }

tl::expected<std::string, core::Violations> create(const Context& context, const json& feature,
                                                   core::UtcTime now) {
  const auto sighting = codec::parse_iceberg_feature(feature);
  if (!sighting) return tl::unexpected(sighting.error());
  IcebergRepository icebergs{context.db};
  const auto dataset = hand_made_dataset(context.db, DatasetKind::icebergs, now);
  const std::int64_t row = icebergs.add(dataset, *sighting);
  refresh_hand_made(context.db, DatasetKind::icebergs, now);
  return std::to_string(row);
}

tl::expected<void, core::Violations> replace(const Context& context, const std::string& id,
                                             const json& feature, core::UtcTime now) {
  const auto sighting = codec::parse_iceberg_feature(feature);
  if (!sighting) return tl::unexpected(sighting.error());
  IcebergRepository{context.db}.replace(key_of(id).value(), *sighting);
  refresh_hand_made(context.db, DatasetKind::icebergs, now);
  return {};
}

void remove(const Context& context, const std::string& id, core::UtcTime now) {
  IcebergRepository{context.db}.remove(key_of(id).value());
  refresh_hand_made(context.db, DatasetKind::icebergs, now);
}

std::string objection(const Context& context, const std::string& id) {
  return objection_to_editing(IcebergRepository{context.db}.find(key_of(id).value())->dataset);
}

}  // namespace

FeatureCollection iceberg_collection() {
  return {.id = "icebergs",
          .title = "Icebergs",
          .description = "Sightings of icebergs, each with its size as stated and as planned with.",
          .schema = "Iceberg",
          .item_name = "row",
          .filters = {"dataset", "latest", "berg_id"},
          .extent = extent,
          .list = list,
          .find = find,
          .editing = FeatureEditing{create, replace, remove, objection}};
}

}  // namespace floeplan::routes
