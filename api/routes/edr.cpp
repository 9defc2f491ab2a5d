#include <cmath>

#include "api/openapi/openapi.hpp"
#include "api/routes/edr_field.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr const char* crs84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";
constexpr const char* openapi_type = "application/vnd.oai.openapi+json;version=3.0";

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

Response show_conformance(const Context&, const Request&, const PathParameters&) {
  json classes = json::array();
  for (const std::string version : {"1.0", "1.1"}) {
    for (const char* name : {"core", "collections", "json", "oas30", "covjson", "queries"})
      classes.push_back("http://www.opengis.net/spec/ogcapi-edr-1/" + version + "/conf/" + name);
  }
  classes.push_back("http://www.opengis.net/spec/ogcapi-common-1/1.0/conf/core");
  classes.push_back("http://www.opengis.net/spec/ogcapi-common-2/1.0/conf/collections");
  return json_reply({{"conformsTo", std::move(classes)}});
}

/// The part of the service's document that lies below /edr, as a document of its own.
Response show_api(const Context& context, const Request&, const PathParameters&) {
  json document = json::parse(openapi::document());
  json paths = json::object();
  for (const auto& [path, operations] : document.at("paths").items()) {
    if (path == "/edr") paths["/"] = operations;
    if (path.starts_with("/edr/")) paths[path.substr(4)] = operations;
  }
  document["paths"] = std::move(paths);
  document["servers"] = json::array({{{"url", base_of(context)}}});
  document["info"]["version"] = FLOEPLAN_VERSION;
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

/// Rounded away from the data, so that a client that prints fewer digits still asks for all of them.
double outwards(double degrees, bool up) {
  const double scaled = degrees * 1e6;
  return (up ? std::ceil(scaled) : std::floor(scaled)) / 1e6;
}

/// Of the newest data. Without time they hold for as long as anybody plans: since the WGS84 was defined, for a century.
json extent_of(const EdrShape& shape) {
  const auto& box = shape.dataset.bounds;
  const bool crosses = box.west_deg > box.east_deg;
  const json corners =
      json::array({crosses ? -180.0 : outwards(box.west_deg, false), outwards(box.south_deg, false),
                   crosses ? 180.0 : outwards(box.east_deg, true), outwards(box.north_deg, true)});
  const std::string from = shape.times.empty() ? "1984-01-01T00:00:00Z" : core::iso8601(shape.times.front());
  const std::string to = shape.times.empty() ? "2084-01-01T00:00:00Z" : core::iso8601(shape.times.back());
  json extent{{"spatial", {{"bbox", json::array({corners})}, {"crs", crs84}}},
              {"temporal", {{"interval", json::array({json::array({from, to})})}, {"trs", "Gregorian"}}}};
  if (!shape.depths_m.empty()) {
    extent["vertical"] = {
        {"interval", json::array({json::array({shape.depths_m.front(), shape.depths_m.back()})})},
        {"values", shape.depths_m},
        {"vrs", "metres below the surface, positive down"}};
  }
  return extent;
}

json collection_json(const Context& context, const EdrCollection& collection, const EdrShape& shape) {
  const std::string self = base_of(context) + "/collections/" + collection.id;
  json parameters = json::object();
  for (const auto& parameter : collection.parameters)
    parameters[parameter.id] = codec::parameter_json(parameter);
  return {{"id", collection.id},
          {"title", collection.title},
          {"description", collection.description + " The newest are " + shape.dataset.name + "."},
          {"extent", extent_of(shape)},
          {"crs", json::array({"CRS84"})},
          {"output_formats", json::array({"CoverageJSON"})},
          {"parameter_names", std::move(parameters)},
          {"data_queries", data_queries(self)},
          {"links",
           {link("self", "application/json", self, collection.title),
            link("data", "application/vnd.cov+json", self + "/position", "At a place")}}};
}

/// Collections that data are stored for.
json all_collections(const Context& context) {
  json collections = json::array();
  for (const EdrCollection& collection : edr_collections()) {
    const auto shape = find_edr_data(context.db, collection, std::nullopt, {});
    if (shape) collections.push_back(collection_json(context, collection, *shape));
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
  return not_found(request, "unknown-collection",
                   "No collection with data has the id " + path.at("collection_id") + ".");
}

}  // namespace

std::vector<Route> edr_routes() {
  return {{"GET", "/edr", {}, show_landing},
          {"GET", "/edr/conformance", {}, show_conformance},
          {"GET", "/edr/api", {}, show_api},
          {"GET", "/edr/collections", {}, list_collections},
          {"GET", "/edr/collections/{collection_id}", {}, show_collection}};
}

}  // namespace floeplan::routes
