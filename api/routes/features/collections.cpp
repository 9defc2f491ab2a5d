#include <vector>

#include "api/routes/features/extent.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/request/feature_crs.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

json extent_json(const FeatureExtent& extent) {
  json document{{"spatial", spatial_extent(std::vector{extent.area})}};
  if (extent.from || extent.to)
    document["temporal"] = temporal_extent(std::vector{ExtentPeriod{extent.from, extent.to}});
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
  return problem_reply<"unknown-collection">(request, path.at("collection_id"));
}

}  // namespace

std::vector<Route> collection_routes() {
  return {{"GET", "/collections", {}, list_collections},
          {"GET", "/collections/{collection_id}", {}, show_collection}};
}

}  // namespace floeplan::routes
