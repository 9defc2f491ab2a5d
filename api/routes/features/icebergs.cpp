#include <algorithm>

#include "api/codec/bytes/text_values.hpp"
#include "api/codec/features/iceberg_feature.hpp"
#include "api/problems/problem_catalogue.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/hand_made.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/features/known_icebergs.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;
using repository::IcebergRepository;
using repository::StoredSighting;

constexpr geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};

/// Query parameters that belong to `latest`.
struct Latest {
  repository::DatasetChoice choice;
  core::Seconds max_age{ocean::max_sighting_age};
  std::optional<core::UtcTime> departure;  // departure of the vehicle; default: the requested time
  std::optional<std::string> berg_id;
};

/// The sightings that count for a plan with this departure, among all sightings up to `as_of`; in ascending
/// order of the row.
std::vector<StoredSighting> latest_of_each(sql::Connection& db, const Latest& latest,
                                           const geo::BoundingBox& area, core::UtcTime as_of) {
  core::Violations none;  // stays empty: the datasets exist, and all intersect the whole world
  auto known = repository::known_icebergs(db, repository::DatasetRepository{db}.list(),
                                          {.choice = latest.choice,
                                           .area = whole_world,
                                           .as_of = as_of,
                                           .depart = latest.departure.value_or(as_of),
                                           .max_age = latest.max_age},
                                          none);
  auto& result = known.sightings;
  std::erase_if(result, [&](const StoredSighting& sighting) {
    return !geo::contains(area, sighting.iceberg.place) ||
           (latest.berg_id && sighting.iceberg.id != *latest.berg_id);
  });
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  return std::move(result);
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

/// Largest age in a query, the same as for plans.
constexpr double oldest_days = ocean::largest_sighting_age.count() / 86'400.0;

/// Ids of datasets, separated by commas in the query.
std::vector<repository::DatasetId> datasets_of(const FeatureQuery& query) {
  std::vector<repository::DatasetId> ids;
  if (const auto text = filter_of(query, "dataset"))
    for (const std::string_view id : codec::split(*text, ',')) ids.push_back({std::string{id}});
  return ids;
}

/// Reads the parameters of `latest`; empty if all sightings are requested, not the latest of each berg.
tl::expected<std::optional<Latest>, problems::Problem> read_latest(const FeatureQuery& query) {
  const std::string wish = filter_of(query, "latest").value_or("false");
  const auto age = filter_of(query, "max_sighting_age_days");
  const double days = age ? codec::parse_number(*age).value_or(-1.0) : 0.0;
  Latest latest;
  latest.berg_id = filter_of(query, "berg_id");
  const auto departure = filter_of(query, "departure");
  if (departure) latest.departure = core::parse_iso8601(*departure);
  latest.choice.ids = datasets_of(query);
  core::Violations violations;
  if (wish != "true" && wish != "false")
    violations.push_back(parameter_fault<"wrong-shape">("latest", "true or false"));
  if (wish == "true" && !query.span.to)
    violations.push_back(parameter_fault<"required">("datetime", "with latest=true, the moment to look at"));
  if (wish != "true" && age)
    violations.push_back(parameter_fault<"needs-latest">(
        "max_sighting_age_days", "; without it, give the first time in \"datetime\""));
  if (departure && !latest.departure)
    violations.push_back(parameter_fault<"wrong-shape">("departure", "a UTC time like 2026-11-20T06:00:00Z"));
  if (wish != "true" && departure)
    violations.push_back(
        parameter_fault<"needs-latest">("departure", ", because ages are counted at the departure"));
  if (days < 0.0 || days > oldest_days)
    violations.push_back(parameter_fault<"wrong-shape">("max_sighting_age_days", "a number from 0 to 30"));
  if (wish != "true" && latest.choice.ids.size() > 1)
    violations.push_back(parameter_fault<"several-without-latest">("dataset"));
  if (!violations.empty())
    return tl::unexpected(problems::problem<"invalid-request">().with(std::move(violations)));
  if (wish == "false") return std::nullopt;
  if (age) latest.max_age = core::Seconds{days * 86'400.0};
  if (!latest.choice.ids.empty()) latest.choice.how = repository::DatasetChoice::How::named;
  return latest;
}

tl::expected<FeaturePage, problems::Problem> list_icebergs(const Context& context,
                                                           const FeatureQuery& query) {
  const auto latest = read_latest(query);
  if (!latest) return tl::unexpected(latest.error());
  for (const auto& id : datasets_of(query)) {
    if (!repository::DatasetRepository{context.db}.find(id))
      return tl::unexpected(problems::problem<"unknown-dataset">(id.value));
  }
  FeaturePage page;
  std::vector<StoredSighting> sightings;
  if (*latest) {
    const auto all = latest_of_each(context.db, **latest, query.area.value_or(whole_world),
                                    query.span.to.value_or(query.now));
    sightings = page_of(all, query.after, query.limit);
    page.matched = std::ssize(all);
  } else {
    const IcebergRepository icebergs{context.db};
    repository::SightingFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
    filter.berg_id = filter_of(query, "berg_id");
    if (const auto ids = datasets_of(query); !ids.empty()) filter.dataset = ids.front();
    sightings = icebergs.list(filter, query.after, query.limit);
    page.matched = icebergs.count(filter);
  }
  for (const auto& sighting : sightings) page.features.push_back(codec::iceberg_feature(sighting));
  if (std::ssize(sightings) == query.limit) page.next = sightings.back().row;
  return page;
}

std::optional<json> find_iceberg(const Context& context, const std::string& id) {
  const auto row = key_of(id);
  const auto sighting = row ? IcebergRepository{context.db}.find(*row) : std::nullopt;
  return sighting ? std::optional{codec::iceberg_feature(*sighting)} : std::nullopt;
}

FeatureExtent iceberg_extent(sql::Connection& db) { return extent_of_kind(db, DatasetKind::icebergs); }

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
          .filters = {"dataset", "latest", "max_sighting_age_days", "departure", "berg_id"},
          .extent = iceberg_extent,
          .list = list_icebergs,
          .find = find_iceberg,
          .editing = FeatureEditing{create, replace, remove, objection}};
}

}  // namespace floeplan::routes
