#include "api/codec/plan_feature.hpp"
#include "api/routes/paging.hpp"
#include "api/routes/parameters.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "storage/repository/plan_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

Response list_plans(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const auto area = reader.bbox();
  const int limit = reader.limit();
  const std::int64_t after = reader.after();
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const repository::PlanRepository repository{context.db};
  const auto plans = repository.list(area, after, limit);
  const std::string& url = context.service.public_url;
  json features = json::array();
  for (const auto& plan : plans) features.push_back(codec::plan_feature(plan));
  json links = json::array({link("self", "application/geo+json", address_of(request, url)),
                            link("collection", "application/json", url + "/collections/plans")});
  if (plans.size() == static_cast<std::size_t>(limit)) {
    links.push_back(link("next", "application/geo+json",
                         address_with(request, url, "after", std::to_string(plans.back().row))));
  }
  return geojson_reply({{"type", "FeatureCollection"},
                        {"features", std::move(features)},
                        {"numberMatched", repository.count(area)},
                        {"numberReturned", plans.size()},
                        {"links", std::move(links)}});
}

Response unknown_plan(const Request& request, const PathParameters& path) {
  return not_found(request, "unknown-plan", "No plan has the id " + path.at("plan_id") + ".");
}

Response show_plan(const Context& context, const Request& request, const PathParameters& path) {
  const auto plan = repository::PlanRepository{context.db}.find({path.at("plan_id")});
  if (!plan) return unknown_plan(request, path);

  json feature = codec::plan_feature(*plan);
  const std::string collection = context.service.public_url + "/collections/plans";
  const std::string self = collection + "/items/" + plan->id.value;
  feature["links"] = json::array(
      {link("self", "application/geo+json", self), link("collection", "application/json", collection),
       link("enclosure", "application/zip", self + "/mission.zip", "GliderDOS mission files"),
       link("enclosure", "application/gpx+xml", self + "/mission.gpx", "GPX route")});
  return geojson_reply(feature);
}

Response remove_plan(const Context& context, const Request& request, const PathParameters& path) {
  if (!repository::PlanRepository{context.db}.remove({path.at("plan_id")}))
    return unknown_plan(request, path);
  Response response;
  response.status = 204;
  return response;
}

}  // namespace

std::vector<Route> plan_routes() {
  return {{"GET", "/collections/plans/items", {"bbox", "limit", "after"}, list_plans},
          {"GET", "/collections/plans/items/{plan_id}", {}, show_plan},
          {"DELETE", "/collections/plans/items/{plan_id}", {}, remove_plan}};
}

}  // namespace floeplan::routes
