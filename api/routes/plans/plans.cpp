#include "api/codec/documents/plan_comparison.hpp"
#include "api/codec/features/plan_feature.hpp"
#include "api/routes/features/feature_collection.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/service/plan_check.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::PlanRepository;

FeatureExtent plan_extent(sql::Connection&) { return {}; }

tl::expected<FeaturePage, problems::Problem> list_plans(const Context& context, const FeatureQuery& query) {
  const PlanRepository plans{context.db};
  const repository::PlanFilter filter{.area = query.area, .from = query.span.from, .to = query.span.to};
  FeaturePage page;
  (void)sql::meets_no_damage([&] { page.matched = plans.count(filter); });
  auto stored = plans.list_past_damage(filter, query.after, query.limit);
  for (const auto& plan : stored.whole) page.features.push_back(codec::plan_feature(plan));
  if (std::ssize(stored.whole) == query.limit) page.next = stored.whole.back().row;
  page.damaged = std::move(stored.damaged);
  return page;
}

std::optional<json> find_plan(const Context& context, const std::string& id) {
  const auto plan = PlanRepository{context.db}.find({id});
  if (!plan) return std::nullopt;
  json feature = codec::plan_feature(*plan);
  const std::string self = context.service.public_url + "/collections/plans/items/" + id;
  feature["links"] =
      json::array({link("enclosure", "application/zip", self + "/mission.zip", "GliderDOS mission files"),
                   link("enclosure", "application/gpx+xml", self + "/mission.gpx", "GPX route"),
                   link("related", "application/json", self + "/check", "What newer data say of it")});
  return feature;
}

Response no_such_plan(const Request& request, const std::string& id) {
  return problem_reply<"unknown-plan">(request, id);
}

/// Reports whether the plan's data have changed, and whether the plan is still valid in the newest data.
Response show_check(const Context& context, const Request& request, const PathParameters& path) {
  const auto plan = PlanRepository{context.db}.find({path.at("plan_id")});
  if (!plan) return no_such_plan(request, path.at("plan_id"));
  Response response = json_reply(service::plan_check_document(*plan, service::check_plan(context.db, *plan)));
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

/// The inputs of the plan, so that it can be evaluated elsewhere by the same rules.
Response show_inputs(const Context& context, const Request& request, const PathParameters& path) {
  const auto plan = PlanRepository{context.db}.find({path.at("plan_id")});
  if (!plan) return no_such_plan(request, path.at("plan_id"));
  return json_reply(json::parse(plan->request_json));
}

Response show_comparison(const Context& context, const Request& request, const PathParameters& path) {
  const PlanRepository plans{context.db};
  const auto first = plans.find({path.at("plan_id")});
  if (!first) return no_such_plan(request, path.at("plan_id"));
  const auto other = request.parameter("with");
  const auto second = other ? plans.find({*other}) : std::nullopt;
  if (!second) {
    return invalid(request, {{"?with", "the query parameter \"with\" must be the id of another plan" +
                                           (other ? ", not " + *other : std::string{})}});
  }
  return json_reply(codec::plan_comparison(*first, *second));
}

Response remove_plan(const Context& context, const Request& request, const PathParameters& path) {
  if (!PlanRepository{context.db}.remove({path.at("plan_id")}))
    return no_such_plan(request, path.at("plan_id"));
  Response response;
  response.status = 204;
  return response;
}

}  // namespace

FeatureCollection plan_collection() {
  return {.id = "plans",
          .title = "Plans",
          .description = "Planned routes with the times, speeds and depths of their waypoints.",
          .schema = "PlanFeature",
          .item_name = "plan_id",
          .filters = {},
          .extent = plan_extent,
          .list = list_plans,
          .find = find_plan};
}

std::vector<Route> plan_routes() {
  return {{"DELETE", "/collections/plans/items/{plan_id}", {}, remove_plan},
          {"GET", "/collections/plans/items/{plan_id}/check", {}, show_check},
          {"GET", "/collections/plans/items/{plan_id}/inputs", {}, show_inputs},
          {"GET", "/collections/plans/items/{plan_id}/comparison", {"with"}, show_comparison}};
}

}  // namespace floeplan::routes
