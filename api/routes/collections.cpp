#include <cmath>

#include "api/routes/feature_collection.hpp"
#include "api/routes/feature_crs.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Rounded away from the data, so that a client that prints fewer digits still asks for all of them.
double outwards(double degrees, bool up) {
  const double scaled = degrees * 1e6;
  return (up ? std::ceil(scaled) : std::floor(scaled)) / 1e6;
}

json extent_json(const FeatureExtent& extent) {
  const auto& area = extent.area;
  const json box = json::array({outwards(area.west_deg, false), outwards(area.south_deg, false),
                                outwards(area.east_deg, true), outwards(area.north_deg, true)});
  json document{{"spatial", {{"bbox", json::array({box})}, {"crs", uri_of(FeatureCrs::crs84)}}}};
  if (!extent.from && !extent.to) return document;
  const auto end_json = [](std::optional<core::UtcTime> time) {
    return time ? json(core::iso8601(*time)) : json();
  };
  document["temporal"] = {
      {"interval", json::array({json::array({end_json(extent.from), end_json(extent.to)})})}};
  return document;
}

json collection_json(const Context& context, const FeatureCollection& collection) {
  const std::string self = context.service.public_url + "/collections/" + collection.id;
  return {{"id", collection.id},
          {"title", collection.title},
          {"description", collection.description},
          {"itemType", "feature"},
          {"crs", crs_uris()},
          {"storageCrs", crs_uris().front()},
          {"extent", extent_json(collection.extent(context.db))},
          {"links",
           {link("self", "application/json", self, collection.title),
            link("items", "application/geo+json", self + "/items", collection.title),
            link("describedBy", "application/schema+json", self + "/schema", "Schema of a feature")}}};
}

Response list_collections(const Context& context, const Request&, const PathParameters&) {
  json collections = json::array();
  for (const auto& collection : feature_collections())
    collections.push_back(collection_json(context, collection));
  const std::string self = context.service.public_url + "/collections";
  return json_reply({{"links", json::array({link("self", "application/json", self, "Collections")})},
                     {"collections", std::move(collections)}});
}

Response show_collection(const Context& context, const Request& request, const PathParameters& path) {
  for (const auto& collection : feature_collections()) {
    if (collection.id == path.at("collection_id")) return json_reply(collection_json(context, collection));
  }
  return not_found(request, "unknown-collection",
                   "No collection has the id " + path.at("collection_id") + ".");
}

}  // namespace

std::vector<Route> collection_routes() {
  return {{"GET", "/collections", {}, list_collections},
          {"GET", "/collections/{collection_id}", {}, show_collection}};
}

}  // namespace floeplan::routes
