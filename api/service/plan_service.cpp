#include "api/service/plan_service.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "api/codec/documents/alternative_document.hpp"
#include "api/codec/documents/departure_document.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/service/coverage_checks.hpp"
#include "api/service/low_water.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/fault.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/evaluate_route.hpp"
#include "engine/planning/find_alternatives.hpp"
#include "engine/planning/plan_arrival.hpp"
#include "engine/planning/plan_route.hpp"
#include "engine/planning/plan_window.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/snapshot.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;

geo::BoundingBox bounds(const planning::Plan& plan) {
  std::vector<geo::LonLat> places;
  places.reserve(plan.waypoints.size());
  for (const auto& waypoint : plan.waypoints) places.push_back(waypoint.place);
  return geo::bounding_box(places);
}

/// Which iceberg sightings counted for the departure, by ocean::oldest_that_counts; null without icebergs.
json sightings_json(const repository::EnvironmentQuery& data, core::UtcTime departure) {
  if (data.icebergs.how == repository::DatasetChoice::How::none) return nullptr;
  const core::UtcTime as_of = repository::sightings_as_of(data);
  return {{"as_of", core::iso8601(as_of)},
          {"max_age_days", data.max_sighting_age.count() / 86'400.0},
          {"oldest", core::iso8601(ocean::oldest_that_counts(as_of, departure, data.max_sighting_age))}};
}

/// Measures the duration of planning, to be stored in the plan.
class Stopwatch {
 public:
  [[nodiscard]] core::Seconds elapsed() const { return std::chrono::steady_clock::now() - begin_; }

 private:
  std::chrono::steady_clock::time_point begin_{std::chrono::steady_clock::now()};
};

/// The plan for the departure, for the best departure of a window, or for the latest departure that arrives
/// in time.
planning::WindowPlan make_plan(const ocean::Environment& environment, const planning::PlanRequest& request,
                               const planning::WiderSea& wider, const core::Executor& executor,
                               const std::stop_token& stop, const core::ProgressCallback& progress) {
  if (request.departures.until)
    return planning::plan_window(environment, request, stop, progress, wider, executor);
  if (request.departures.arrive_by) {
    return {.departures = {},
            .plan = planning::plan_arrival(environment, request, stop, progress, wider, executor)};
  }
  return {.departures = {},
          .plan = planning::plan_route(environment, request, stop, progress, wider, executor)};
}

std::vector<GivenPlace> given_places(const planning::PlanRequest& request) {
  std::vector<GivenPlace> places{{"from", request.from}};
  for (std::size_t i = 0; i < request.via.size(); ++i)
    places.emplace_back("via/" + std::to_string(i), request.via[i]);
  places.emplace_back("to", request.to);
  return places;
}

/// Adds what no planner knows: the water levels on the plan's route, and the remarks of its inputs.
void add_messages(sql::Connection& db, const ocean::Environment& environment,
                  const vehicle::GliderProfile& vehicle, const std::vector<std::string>& remarks,
                  planning::Plan& plan) {
  if (auto caution = low_water_caution(db, environment, vehicle, plan))
    plan.messages.push_back(std::move(*caution));
  for (const std::string& remark : remarks) plan.messages.push_back(messages::plan_message<"remark">(remark));
}

/// Adds the outcomes of all departures to the document of a window.
void add_departures(json& document, const std::vector<planning::DepartureOutcome>& departures) {
  if (!departures.empty()) document["departures"] = codec::departures_json(departures);
}

/// Gives the plan an id and stores it with its document.
/// `besides`  further members of the document
/// Returns  the whole document; if a plan with this id is already stored, that plan's document, because it is
///          the one that is flown and exported
json keep(sql::Connection& db, const codec::PlanInputs& inputs, const planning::Plan& plan, core::UtcTime now,
          const json& besides = json::object()) {
  const json request = codec::to_json(inputs);
  const std::string id = codec::plan_identity(request, plan);
  json document = codec::plan_document(plan, id, inputs.name);
  document["sightings"] = sightings_json(inputs.data, plan.departure);
  document.update(besides);
  repository::PlanRepository plans{db};
  plans.insert({.row = 0,
                .id = {id},
                .name = inputs.name,
                .created = now,
                .departure = plan.departure,
                .arrival = plan.arrival,
                .bounds = bounds(plan),
                .request_json = request.dump(),
                .document_json = document.dump()});
  const auto stored = plans.find({id});
  return stored ? json::parse(stored->document_json) : document;
}

/// Stores each alternative as a separate plan.
/// Returns  their entries for the document of the main plan
json keep_alternatives(sql::Connection& db, const ocean::Environment& environment,
                       const codec::PlanInputs& inputs, std::vector<planning::Alternative>& alternatives,
                       core::UtcTime now) {
  json list = json::array();
  for (planning::Alternative& alternative : alternatives) {
    codec::PlanInputs own = inputs;
    own.request = alternative.request;
    own.name =
        (inputs.name.empty() ? "" : inputs.name + ", ") + "alternative " + std::to_string(list.size() + 1);
    add_messages(db, environment, own.request.vehicle, inputs.warnings, alternative.plan);
    list.push_back(codec::alternative_json(alternative, keep(db, own, alternative.plan, now)));
  }
  return list;
}

repository::Reading reading(const std::stop_token& stop, KeptWork* kept) {
  return {stop, kept != nullptr ? &kept->currents : nullptr};
}

GroundKey ground_key(sql::Connection& db, const codec::EvaluateInputs& inputs,
                     const planning::PlanRequest& on_route) {
  json conditions = codec::to_json(inputs);
  for (const char* other : {"name", "plan_id", "remarks", "route"}) conditions.erase(other);
  return {.conditions = conditions.dump(),
          .contents = repository::DatasetRepository{db}.contents(),
          .area = inputs.data.area,
          .site = planning::search::site_of(on_route)};
}

}  // namespace

tl::expected<json, core::Violations> plan_route_document(sql::Connection& db, const codec::PlanInputs& inputs,
                                                         const core::Executor& executor,
                                                         const std::stop_token& stop,
                                                         const core::ProgressCallback& progress,
                                                         core::UtcTime now, KeptWork* kept) {
  if (progress) progress("loading data", 0.0);
  if (auto swapped = swapped_places(db, given_places(inputs.request), inputs.data); !swapped.empty())
    return tl::unexpected(std::move(swapped));
  if (auto elsewhere = depths_elsewhere(db, inputs.data); !elsewhere.empty())
    return tl::unexpected(std::move(elsewhere));
  const auto environment = repository::load_environment(db, inputs.data, reading(stop, kept));
  if (!environment) return tl::unexpected(environment.error());

  const planning::WiderSea wider =
      [&](const planning::PlanRequest& roomy) -> std::optional<ocean::Environment> {
    repository::EnvironmentQuery query = inputs.data;
    query.area = codec::area_of_data(roomy);
    auto sea = repository::load_environment(db, query, reading(stop, kept));
    if (!sea || stop.stop_requested()) return std::nullopt;
    return std::move(*sea);
  };
  const planning::PlanRequest& request = inputs.request;
  const double share_of_plan = 1.0 / (1.0 + request.alternatives);
  const core::ProgressCallback of_plan = core::part_of(progress, "", 0.0, share_of_plan);
  const core::ProgressCallback of_alternatives = core::part_of(progress, "", share_of_plan, 1.0);
  const Stopwatch watch;
  auto [departures, plan] = make_plan(*environment, request, wider, executor, stop, of_plan);
  if (!plan) {
    json document = codec::infeasible_document(plan.error(), *environment);
    add_departures(document, departures);
    return document;
  }
  json besides = json::object();
  add_departures(besides, departures);
  if (request.alternatives > 0) {
    auto alternatives =
        planning::find_alternatives(*environment, request, *plan, stop, of_alternatives, executor);
    if (!alternatives) return codec::infeasible_document(alternatives.error(), *environment);
    if (alternatives->better) plan = std::move(*alternatives->better);
    besides["alternatives"] = keep_alternatives(db, *environment, inputs, alternatives->found, now);
    if (alternatives->fewer) plan->messages.push_back(*alternatives->fewer);
  }
  plan->search.duration = watch.elapsed();
  add_messages(db, *environment, request.vehicle, inputs.warnings, *plan);
  return keep(db, inputs, *plan, now, besides);
}

tl::expected<json, core::Violations> evaluate_route_document(sql::Connection& db,
                                                             codec::EvaluateInputs inputs,
                                                             const std::stop_token& stop, KeptWork* kept) {
  if (inputs.plan_id) {
    const auto stored = repository::PlanRepository{db}.find({*inputs.plan_id});
    if (!stored)
      return tl::unexpected(core::Violations{messages::fault<"no-such-plan">("/plan_id", *inputs.plan_id)});
    codec::set_route(inputs, codec::route_of(json::parse(stored->document_json)));
  }
  const planning::PlanRequest on_route = planning::search::request_along(inputs.route, inputs.request);
  const sql::Snapshot one_moment{db};
  const GroundKey key = ground_key(db, inputs, on_route);
  auto ground = kept != nullptr ? kept->grounds.find(key) : nullptr;

  const Stopwatch watch;
  if (!ground) {
    const auto environment = repository::load_environment(db, inputs.data, reading(stop, kept));
    if (!environment) return tl::unexpected(environment.error());
    const auto laid_out = planning::search::lay_out_ground(*environment, on_route, key.site, stop);
    if (!laid_out) return codec::infeasible_document(laid_out.error(), *environment);
    ground = *laid_out;
    if (kept != nullptr) kept->grounds.keep(key, ground, ground->bytes());
  }
  auto plan = planning::evaluate_route(*ground, inputs.route, inputs.request, stop);
  if (!plan) return codec::infeasible_document(plan.error(), ground->environment());
  plan->search.duration = watch.elapsed();
  add_messages(db, ground->environment(), inputs.request.vehicle, inputs.warnings, *plan);
  json document = codec::plan_document(*plan, "", inputs.name);
  document["sightings"] = sightings_json(inputs.data, plan->departure);
  return document;
}

}  // namespace floeplan::service
