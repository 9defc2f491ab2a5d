#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "api/codec/bytes/sha256.hpp"
#include "api/openapi/openapi.hpp"
#include "api/routes/request/openapi_schema.hpp"
#include "api/routes/request/preferences.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/routes/request/router.hpp"
#include "api/routes/server/assets.hpp"
#include "engine/core/letter_case.hpp"
#include "engine/core/version.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

/// Whether a path template of the document belongs to an operation. They differ if a parameter takes the rest
/// of the path, or if an operation serves several templates ("/processes/{process_id}/execution").
bool is_template_of(const Route& route, const std::string& path) {
  const std::string_view pattern = route.pattern;
  std::size_t at = 0;
  std::size_t in_path = 0;
  while (at < pattern.size() && in_path < path.size()) {
    if (pattern[at] == '{') {
      at = pattern.find('}', at) + 1;
      in_path = std::min(path.find('/', in_path), path.size());
    } else if (pattern[at++] != path[in_path++]) {
      return false;
    }
  }
  return at == pattern.size() && in_path == path.size();
}

void describe(json& operation, const Route& route) {
  const auto least = least_role(route);
  if (!least) {
    operation["security"] = json::array();
    return;
  }
  operation["security"] = {{{"token", json::array()}}, {{"login", json::array()}}};
  operation["x-role"] = repository::role_name(*least);
  for (const char* status : {"401", "403", "429"})
    operation["responses"][status] = {{"$ref", "#/components/responses/Problem"}};
}

/// Adds the access rules of each operation to an OpenAPI document: the security schemes, the least role
/// ("x-role"), and the responses without access (401, 403, 429). They are derived from the operations, so the
/// document cannot differ from them.
void describe_doors(json& document, const std::vector<Route>& routes) {
  for (auto& [path, operations] : document["paths"].items()) {
    for (const Route& route : routes) {
      const auto operation = operations.find(core::lower_case(route.method));
      if (operation != operations.end() && is_template_of(route, path)) describe(*operation, route);
    }
  }
}

json landing_page(const std::string& url) {
  const std::string ogc = "http://www.opengis.net/def/rel/ogc/1.0/";
  return {{"title", "Floeplan"},
          {"description", "Mission planning for underwater gliders that work around and under ice."},
          {"links",
           {link("self", "application/json", url + "/", "This document"),
            link("alternate", "text/html", url + "/?f=html", "The map"),
            link("service-desc", openapi_type, url + "/api", "The API"),
            link("help", "text/html", url + "/guide", "The guide"),
            link("conformance", "application/json", url + "/conformance", "Conformance classes"),
            link(ogc + "conformance", "application/json", url + "/conformance", "Conformance classes"),
            link("data", "application/json", url + "/collections", "Feature collections"),
            link("processes", "application/json", url + "/processes", "Processes"),
            link(ogc + "processes", "application/json", url + "/processes", "Processes"),
            link(ogc + "job-list", "application/json", url + "/jobs", "Jobs")}}};
}

Response show_landing_page(const Context& context, const Request& request, const PathParameters&) {
  const auto format = request.parameter("f");
  const bool html =
      format ? *format == "html" || *format == "text/html" : prefers_html(request.header("accept"));
  auto page = html ? read_asset(context.service.web, "index.html") : std::nullopt;
  if (!page && html && format) {
    return problem_reply<"no-client">(request);
  }
  Response response = page ? std::move(*page) : json_reply(landing_page(context.service.public_url));
  response.headers.emplace_back("Vary", "Accept");
  return response;
}

Response show_conformance(const Context&, const Request&, const PathParameters&) {
  const std::string features = "http://www.opengis.net/spec/ogcapi-features-1/1.0/conf/";
  const std::string editing = "http://www.opengis.net/spec/ogcapi-features-4/1.0/conf/";
  const std::string processes = "http://www.opengis.net/spec/ogcapi-processes-1/1.0/conf/";
  return json_reply(
      {{"conformsTo",
        {features + "core", features + "geojson", features + "oas30",
         "http://www.opengis.net/spec/ogcapi-features-2/1.0/conf/crs", editing + "create-replace-delete",
         editing + "update", editing + "features", editing + "optimistic-locking-etags", processes + "core",
         processes + "ogc-process-description", processes + "json", processes + "oas30",
         processes + "job-list", processes + "dismiss"}}});
}

Response api_document(const std::string& url) {
  json document = json::parse(openapi::document());
  document["servers"] = json::array({{{"url", url}}});
  document["info"]["version"] = core::version();
  describe_doors(document, all_routes());
  Response response = json_reply(document, 200, openapi_type);
  response.headers.emplace_back("ETag", '"' + codec::sha256(response.body).substr(0, 32) + '"');
  return response;
}

/// The OpenAPI document with its entity tag. It is large and equal for all requests, so it is created once.
class ApiDocument {
 public:
  Response at(const std::string& url) {
    const std::lock_guard lock{mutex_};
    if (!made_ || url != url_) {
      made_ = api_document(url);
      url_ = url;
    }
    return *made_;
  }

 private:
  std::mutex mutex_;
  std::string url_;
  std::optional<Response> made_;
};

}  // namespace

std::vector<Route> landing_routes() {
  const auto document = std::make_shared<ApiDocument>();
  const auto show_api = [document](const Context& context, const Request&, const PathParameters&) {
    return document->at(context.service.public_url);
  };
  return {{"GET", "/", {}, show_landing_page, Access::everybody},
          {"GET", "/conformance", {}, show_conformance, Access::everybody},
          {"GET", "/api", {}, show_api, Access::everybody}};
}

}  // namespace floeplan::routes
