#include "api/codec/bytes/sha256.hpp"
#include "api/codec/bytes/text_values.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/features/feature_edits.hpp"
#include "api/routes/request/feature_crs.hpp"
#include "api/routes/request/openapi_schema.hpp"
#include "api/routes/request/paging.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/routes/request/store_trouble.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

Response with_crs(Response response, FeatureCrs crs) {
  response.headers.emplace_back("Content-Crs", "<" + uri_of(crs) + ">");
  return response;
}

FeatureQuery read_query(ParameterReader& reader, const FeatureCollection& collection,
                        const Request& request) {
  FeatureQuery query;
  query.area = reader.bbox(reader.crs("bbox-crs"));
  query.span = reader.datetime();
  query.limit = reader.limit();
  query.after = reader.after();
  query.now = request.now;
  for (const auto& name : collection.filters) {
    if (const auto value = request.parameter(name)) query.filters[name] = *value;
  }
  return query;
}

Response list_items(const FeatureCollection& collection, const Context& context, const Request& request) {
  ParameterReader reader{request};
  const FeatureCrs crs = reader.crs("crs");
  const FeatureQuery query = read_query(reader, collection, request);
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  auto page = collection.list(context, query);
  if (!page) return problem_reply(request, page.error());

  const std::string& url = context.service.public_url;
  json links = json::array(
      {link("self", "application/geo+json", address_of(request, url)),
       link("collection", "application/json", url + "/collections/" + collection.id, collection.title)});
  if (page->next) {
    links.push_back(link("next", "application/geo+json",
                         address_with(request, url, "after", std::to_string(*page->next)), "Next page"));
  }
  json document{{"type", "FeatureCollection"}, {"features", json::array()}, {"links", std::move(links)}};
  document["numberReturned"] = page->features.size();
  if (page->matched) document["numberMatched"] = *page->matched;
  for (json& feature : page->features) {
    express_in(feature.at("geometry"), crs);
    document["features"].push_back(std::move(feature));
  }
  name_damaged(document, page->damaged);
  return with_crs(geojson_reply(document), crs);
}

Response show_item(const FeatureCollection& collection, const Context& context, const Request& request,
                   const std::string& id) {
  ParameterReader reader{request};
  const FeatureCrs crs = reader.crs("crs");
  if (!reader.violations().empty()) return invalid(request, reader.violations());
  auto feature = collection.find(context, id);
  if (!feature) return no_such_feature(request, collection, id);

  const bool editable = crs == FeatureCrs::crs84 && collection.editing.has_value();
  const std::string tag = editable ? feature_tag(*feature) : std::string{};
  const std::string self = context.service.public_url + "/collections/" + collection.id;
  json links = json::array({link("self", "application/geo+json", self + "/items/" + id),
                            link("collection", "application/json", self, collection.title)});
  for (json& more : feature->value("links", json::array())) links.push_back(std::move(more));
  (*feature)["links"] = std::move(links);
  express_in(feature->at("geometry"), crs);
  Response response = with_crs(geojson_reply(*feature), crs);
  if (editable) response.headers.emplace_back("ETag", '"' + tag + '"');
  return response;
}

/// The JSON schema of a feature, from which GDAL reads the types of attributes.
Response show_schema(const FeatureCollection& collection) {
  json schema = openapi_schema(collection.schema);
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = collection.title;
  return json_reply(schema, 200, "application/schema+json");
}

void add_editing(std::vector<Route>& routes, const FeatureCollection& collection, const std::string& items,
                 const std::string& item) {
  const std::string& name = collection.item_name;
  routes.push_back({"POST",
                    items,
                    {},
                    [&collection](const Context& context, const Request& request, const PathParameters&) {
                      return create_feature(collection, context, request);
                    }});
  routes.push_back(
      {"PUT",
       item,
       {},
       [&collection, &name](const Context& context, const Request& request, const PathParameters& path) {
         return replace_feature(collection, context, request, path.at(name));
       }});
  routes.push_back(
      {"PATCH",
       item,
       {},
       [&collection, &name](const Context& context, const Request& request, const PathParameters& path) {
         return update_feature(collection, context, request, path.at(name));
       }});
  routes.push_back(
      {"DELETE",
       item,
       {},
       [&collection, &name](const Context& context, const Request& request, const PathParameters& path) {
         return remove_feature(collection, context, request, path.at(name));
       }});
}

}  // namespace

const std::vector<FeatureCollection>& feature_collections() {
  static const std::vector<FeatureCollection> collections{
      iceberg_collection(), iceberg_track_collection(), glider_track_collection(), isobath_collection(),
      zone_collection(),    plan_collection(),          plan_leg_collection(),     waypoint_collection()};
  return collections;
}

std::optional<std::int64_t> key_of(const std::string& text) { return codec::parse_integer(text); }

std::vector<Route> feature_routes() {
  std::vector<Route> routes;
  for (const FeatureCollection& collection : feature_collections()) {
    const std::string base = "/collections/" + collection.id;
    const std::string items = base + "/items";
    const std::string item = items + "/{" + collection.item_name + "}";
    std::vector<std::string> parameters{"bbox", "bbox-crs", "crs", "datetime", "limit", "after"};
    parameters.insert(parameters.end(), collection.filters.begin(), collection.filters.end());
    routes.push_back({"GET", items, parameters,
                      [&collection](const Context& context, const Request& request, const PathParameters&) {
                        return list_items(collection, context, request);
                      }});
    routes.push_back(
        {"GET",
         item,
         {"crs"},
         [&collection](const Context& context, const Request& request, const PathParameters& path) {
           return show_item(collection, context, request, path.at(collection.item_name));
         }});
    routes.push_back(
        {"GET", base + "/schema", {}, [&collection](const Context&, const Request&, const PathParameters&) {
           return show_schema(collection);
         }});
    if (collection.editing) add_editing(routes, collection, items, item);
  }
  return routes;
}

}  // namespace floeplan::routes
