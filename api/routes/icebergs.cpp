#include <algorithm>
#include <charconv>
#include <map>

#include "api/codec/iceberg_feature.hpp"
#include "api/routes/paging.hpp"
#include "api/routes/parameters.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/environment_loader.hpp"
#include "storage/repository/iceberg_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::StoredSighting;

constexpr geo::BoundingBox whole_world{-180.0, -90.0, 180.0, 90.0};

struct Page {
  std::vector<StoredSighting> sightings;
  std::int64_t matched{};
};

/// The newest sighting of each berg over the datasets asked for, by ascending row.
std::vector<StoredSighting> latest_of_each(sqlite::Connection& db, const repository::SightingFilter& filter,
                                           core::UtcTime as_of) {
  std::map<std::string, StoredSighting> newest;
  for (const auto& dataset : repository::DatasetRepository{db}.list()) {
    if (dataset.kind != repository::DatasetKind::icebergs) continue;
    if (filter.dataset && dataset.id != *filter.dataset) continue;
    for (auto& sighting :
         repository::IcebergRepository{db}.latest(dataset.id, filter.area.value_or(whole_world), as_of,
                                                  as_of - repository::oldest_sighting_used(as_of))) {
      const auto [place, added] = newest.try_emplace(sighting.iceberg.id, sighting);
      if (!added && place->second.iceberg.observed < sighting.iceberg.observed)
        place->second = std::move(sighting);
    }
  }
  std::vector<StoredSighting> result;
  for (auto& [berg, sighting] : newest) result.push_back(std::move(sighting));
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.row < b.row; });
  return result;
}

Page page_of(std::vector<StoredSighting> all, std::int64_t after, int limit) {
  Page page{{}, static_cast<std::int64_t>(all.size())};
  for (auto& sighting : all) {
    if (sighting.row > after && page.sightings.size() < static_cast<std::size_t>(limit)) {
      page.sightings.push_back(std::move(sighting));
    }
  }
  return page;
}

json feature_with_links(const StoredSighting& sighting, const std::string& public_url) {
  json feature = codec::iceberg_feature(sighting);
  const std::string collection = public_url + "/collections/icebergs";
  feature["links"] = json::array(
      {link("self", "application/geo+json", collection + "/items/" + std::to_string(sighting.row)),
       link("collection", "application/json", collection)});
  return feature;
}

Response list_icebergs(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  repository::SightingFilter filter;
  filter.area = reader.bbox();
  const TimeSpan span = reader.datetime();
  filter.from = span.from;
  filter.to = span.to;
  if (const auto dataset = request.parameter("dataset")) filter.dataset = repository::DatasetId{*dataset};
  const bool latest = reader.flag("latest");
  if (latest) reader.require("datetime", "with latest=true, the moment to look at");
  const int limit = reader.limit();
  const std::int64_t after = reader.after();
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  if (filter.dataset && !repository::DatasetRepository{context.db}.find(*filter.dataset)) {
    return not_found(request, "unknown-dataset", "No dataset has the id " + filter.dataset->value + ".");
  }

  const repository::IcebergRepository icebergs{context.db};
  Page page;
  if (latest) {
    page = page_of(latest_of_each(context.db, filter, span.to.value_or(request.now)), after, limit);
  } else {
    page = {icebergs.list(filter, after, limit), icebergs.count(filter)};
  }

  const std::string& url = context.service.public_url;
  json features = json::array();
  for (const auto& sighting : page.sightings) features.push_back(codec::iceberg_feature(sighting));
  json links = json::array({link("self", "application/geo+json", address_of(request, url)),
                            link("collection", "application/json", url + "/collections/icebergs")});
  if (page.sightings.size() == static_cast<std::size_t>(limit)) {
    links.push_back(link("next", "application/geo+json",
                         address_with(request, url, "after", std::to_string(page.sightings.back().row))));
  }
  return geojson_reply({{"type", "FeatureCollection"},
                        {"features", std::move(features)},
                        {"numberMatched", page.matched},
                        {"numberReturned", page.sightings.size()},
                        {"links", std::move(links)}});
}

Response show_iceberg(const Context& context, const Request& request, const PathParameters& path) {
  const std::string& text = path.at("row");
  std::int64_t row = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), row);
  const bool number = error == std::errc{} && end == text.data() + text.size();
  const auto sighting = number ? repository::IcebergRepository{context.db}.find(row) : std::nullopt;
  if (!sighting) return not_found(request, "unknown-feature", "No sighting has the id " + text + ".");
  return geojson_reply(feature_with_links(*sighting, context.service.public_url));
}

}  // namespace

std::vector<Route> iceberg_routes() {
  return {{"GET",
           "/collections/icebergs/items",
           {"bbox", "datetime", "limit", "after", "dataset", "latest"},
           list_icebergs},
          {"GET", "/collections/icebergs/items/{row}", {}, show_iceberg}};
}

}  // namespace floeplan::routes
