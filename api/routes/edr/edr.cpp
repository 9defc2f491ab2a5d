#include <chrono>
#include <set>
#include <utility>
#include <vector>

#include "api/openapi/openapi.hpp"
#include "api/routes/edr/edr_field.hpp"
#include "api/routes/features/extent.hpp"
#include "api/routes/request/openapi_schema.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/version.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr const char* crs84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";

std::string base_of(const Context& context) { return context.service.public_url + "/edr"; }

Response show_landing(const Context& context, const Request&, const PathParameters&) {
  const std::string url = base_of(context);
  return json_reply({{"title", "Floeplan: data of the sea"},
                     {"description", "Currents, depths and sea ice that missions are planned with."},
                     {"links",
                      {link("service-desc", openapi_type, url + "/api", "The API"),
                       link("self", "application/json", url + "/", "This document"),
                       link("conformance", "application/json", url + "/conformance", "Conformance classes"),
                       link("data", "application/json", url + "/collections", "Collections")}}});
}

Response show_edr_conformance(const Context&, const Request&, const PathParameters&) {
  json classes = json::array();
  for (const std::string version : {"1.0", "1.1"}) {
    for (const char* name : {"core", "collections", "json", "oas30", "covjson", "queries"})
      classes.push_back("http://www.opengis.net/spec/ogcapi-edr-1/" + version + "/conf/" + name);
  }
  classes.push_back("http://www.opengis.net/spec/ogcapi-common-1/1.0/conf/core");
  classes.push_back("http://www.opengis.net/spec/ogcapi-common-2/1.0/conf/collections");
  return json_reply({{"conformsTo", std::move(classes)}});
}

/// The part of the service's OpenAPI document below /edr, as a separate document.
Response show_api(const Context& context, const Request&, const PathParameters&) {
  json document = json::parse(openapi::document());
  json paths = json::object();
  for (const auto& [path, operations] : document.at("paths").items()) {
    if (path == "/edr") paths["/"] = operations;
    if (path.starts_with("/edr/")) paths[path.substr(4)] = operations;
  }
  document["paths"] = std::move(paths);
  document["servers"] = json::array({{{"url", base_of(context)}}});
  document["info"]["version"] = core::version();
  return json_reply(document, 200, openapi_type);
}

json data_queries(const std::string& self) {
  json queries = json::object();
  for (const std::string name : {"position", "radius", "area", "cube", "trajectory"}) {
    json variables{{"title", name},
                   {"query_type", name},
                   {"output_formats", json::array({"CoverageJSON"})},
                   {"default_output_format", "CoverageJSON"},
                   {"crs_details", json::array({{{"crs", "CRS84"}, {"wkt", crs84}}})}};
    if (name == "radius") variables["within_units"] = {"m", "km", "nmi", "mi"};
    queries[name] = {{"link",
                      {{"href", self + "/" + name},
                       {"rel", "data"},
                       {"type", "application/vnd.cov+json"},
                       {"variables", std::move(variables)}}}};
  }
  return queries;
}

/// The combined extent of all datasets of a collection.
struct EdrExtent {
  std::vector<geo::BoundingBox> boxes;
  std::vector<ExtentPeriod> periods;
  std::set<double> depths_m;
};

/// The period of a dataset. Data without time get a century from the definition of WGS84 on, long enough for
/// any plan.
ExtentPeriod period_of(const EdrShape& shape) {
  if (!shape.times.empty()) return {shape.times.front(), shape.times.back()};
  using namespace std::chrono;
  return {core::UtcTime{sys_days{1984y / January / 1}}, core::UtcTime{sys_days{2084y / January / 1}}};
}

EdrExtent extent_of(const std::vector<EdrShape>& shapes) {
  EdrExtent extent;
  for (const EdrShape& shape : shapes) {
    extent.boxes.push_back(shape.dataset.bounds);
    extent.periods.push_back(period_of(shape));
    extent.depths_m.insert(shape.depths_m.begin(), shape.depths_m.end());
  }
  return extent;
}

json extent_json(const EdrExtent& extent) {
  json document{{"spatial", spatial_extent(extent.boxes)}, {"temporal", temporal_extent(extent.periods)}};
  document["temporal"]["trs"] = "Gregorian";
  if (!extent.depths_m.empty()) {
    document["vertical"] = {
        {"interval", json::array({json::array({*extent.depths_m.begin(), *extent.depths_m.rbegin()})})},
        {"values", extent.depths_m},
        {"vrs", "metres below the surface, positive down"}};
  }
  return document;
}

/// `shapes`  of all datasets of the collection, newest first
json collection_json(const Context& context, const EdrCollection& collection,
                     const std::vector<EdrShape>& shapes) {
  const std::string self = base_of(context) + "/collections/" + collection.id;
  json parameters = json::object();
  for (const auto& parameter : collection.parameters)
    parameters[parameter.id] = codec::parameter_json(parameter);
  return {{"id", collection.id},
          {"title", collection.title},
          {"description", collection.description},
          {"extent", extent_json(extent_of(shapes))},
          {"crs", json::array({"CRS84"})},
          {"output_formats", json::array({"CoverageJSON"})},
          {"parameter_names", std::move(parameters)},
          {"data_queries", data_queries(self)},
          {"links",
           {link("self", "application/json", self, collection.title),
            link("data", "application/vnd.cov+json", self + "/position", "At a place")}}};
}

/// All collections that have stored data.
json all_collections(const Context& context) {
  json collections = json::array();
  for (const EdrCollection& collection : edr_collections()) {
    std::vector<EdrShape> shapes;
    for (const auto& dataset : edr_datasets(context.db, collection, std::nullopt, {}))
      if (auto shape = edr_shape(context.db, dataset)) shapes.push_back(std::move(*shape));
    if (!shapes.empty()) collections.push_back(collection_json(context, collection, shapes));
  }
  return collections;
}

Response list_collections(const Context& context, const Request&, const PathParameters&) {
  const std::string self = base_of(context) + "/collections";
  return json_reply({{"links", json::array({link("self", "application/json", self, "Collections")})},
                     {"collections", all_collections(context)}});
}

Response show_collection(const Context& context, const Request& request, const PathParameters& path) {
  for (const auto& collection : all_collections(context)) {
    if (collection.at("id") == path.at("collection_id")) return json_reply(collection);
  }
  return problem_reply<"unknown-data-collection">(request, path.at("collection_id"));
}

}  // namespace

std::vector<Route> edr_routes() {
  return {{"GET", "/edr", {}, show_landing},
          {"GET", "/edr/conformance", {}, show_edr_conformance},
          {"GET", "/edr/api", {}, show_api},
          {"GET", "/edr/collections", {}, list_collections},
          {"GET", "/edr/collections/{collection_id}", {}, show_collection}};
}

}  // namespace floeplan::routes
