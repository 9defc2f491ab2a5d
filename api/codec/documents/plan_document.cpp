#include "api/codec/documents/plan_document.hpp"

#include <stdexcept>
#include <type_traits>
#include <variant>

#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/sha256.hpp"
#include "api/codec/documents/dataset_document.hpp"
#include "api/codec/documents/older_plans.hpp"
#include "api/codec/documents/passage_document.hpp"
#include "api/codec/documents/surfacing_document.hpp"
#include "api/codec/inputs/uncertainty_inputs.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/messages/store_messages.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

template <class Tag>
json optional_value(const std::optional<core::Quantity<Tag>>& quantity) {
  return quantity ? json(quantity->value) : json();
}

json optional_number(const std::optional<double>& number) { return number ? json(*number) : json(); }

json waypoint_json(const planning::Waypoint& waypoint, std::size_t index) {
  return {{"index", index},
          {"lon", document_degrees(waypoint.place.lon_deg)},
          {"lat", document_degrees(waypoint.place.lat_deg)},
          {"eta", core::iso8601(waypoint.eta)},
          {"wait_s", waypoint.wait.count()},
          {"leg_m", optional_value(waypoint.leg_length)},
          {"course_deg", optional_number(waypoint.course_deg)},
          {"speed_over_ground_m_s", optional_value(waypoint.speed_over_ground)},
          {"depth_m", optional_value(waypoint.depth)},
          {"iceberg_encounters", optional_number(waypoint.iceberg_encounters)},
          {"energy_j", optional_value(waypoint.energy)},
          {"propulsion", waypoint.drive ? json(planning::drive_name(*waypoint.drive)) : json()},
          {"speed_through_water_m_s", optional_value(waypoint.speed_through_water)},
          {"current_east_m_s", waypoint.current ? json(waypoint.current->east.value) : json()},
          {"current_north_m_s", waypoint.current ? json(waypoint.current->north.value) : json()}};
}

std::optional<double> stored_number(const json& object, const char* key) {
  const json& value = object.at(key);
  return value.is_null() ? std::nullopt : std::optional{value.get<double>()};
}

std::optional<core::Metres> metres_at(const json& object, const char* key) {
  const auto value = stored_number(object, key);
  return value ? std::optional{core::Metres{*value}} : std::nullopt;
}

json energy_json(const std::optional<planning::PlanEnergy>& energy) {
  if (!energy) return nullptr;
  return {{"hotel_j", energy->use.hotel.value},
          {"pump_j", energy->use.pump.value},
          {"thruster_j", energy->use.thruster.value},
          {"inflections", energy->use.inflections},
          {"usable_j", energy->usable.value}};
}

std::optional<planning::PlanEnergy> parse_energy(const json& energy) {
  if (energy.is_null()) return std::nullopt;
  return planning::PlanEnergy{.use = {.hotel = {energy.at("hotel_j").get<double>()},
                                      .pump = {energy.at("pump_j").get<double>()},
                                      .thruster = {energy.at("thruster_j").get<double>()},
                                      .inflections = energy.at("inflections").get<double>()},
                              .usable = {energy.at("usable_j").get<double>()}};
}

template <class Quantity>
std::optional<Quantity> stored_quantity(const json& object, const char* key) {
  const auto number = stored_number(object, key);
  return number ? std::optional{Quantity{*number}} : std::nullopt;
}

/// The drive that a plan document stores for the leg to a waypoint; empty for the start, to which no leg leads.
std::optional<vehicle::Drive> stored_drive(const json& object) {
  const json& name = object.at("propulsion");
  if (name.is_null()) return std::nullopt;
  const auto drive = planning::parse_drive(name.get<std::string>());
  if (!drive)
    throw std::runtime_error{
        messages::store_text<"stored-plan-unreadable">("a leg has an unknown propulsion")};
  return drive;
}

std::optional<geo::VelocityEn> stored_current(const json& object) {
  const auto east = stored_quantity<core::MetresPerSecond>(object, "current_east_m_s");
  const auto north = stored_quantity<core::MetresPerSecond>(object, "current_north_m_s");
  if (!east || !north) return std::nullopt;
  return geo::VelocityEn{*east, *north};
}

planning::Waypoint parse_waypoint(const json& object) {
  planning::Waypoint waypoint{
      .place = {object.at("lon").get<double>(), object.at("lat").get<double>()},
      .eta = stored_time(object, "eta"),
      .leg_length = metres_at(object, "leg_m"),
      .course_deg = stored_number(object, "course_deg"),
      .speed_over_ground = stored_quantity<core::MetresPerSecond>(object, "speed_over_ground_m_s"),
      .depth = metres_at(object, "depth_m"),
      .iceberg_encounters = stored_number(object, "iceberg_encounters")};
  waypoint.wait = core::Seconds{object.at("wait_s").get<double>()};
  waypoint.drive = stored_drive(object);
  waypoint.speed_through_water = stored_quantity<core::MetresPerSecond>(object, "speed_through_water_m_s");
  waypoint.current = stored_current(object);
  waypoint.energy = stored_quantity<core::Joules>(object, "energy_j");
  return waypoint;
}

std::optional<core::Seconds> parse_possible_gain(const json& search) {
  const auto gain_s = stored_number(search, "possible_gain_s");
  return gain_s ? std::optional{core::Seconds{*gain_s}} : std::nullopt;
}

json refinement_json(const std::optional<planning::RefinementReport>& refinement) {
  if (!refinement) return nullptr;
  json result{{"before_s", refinement->before.count()},
              {"after_s", refinement->after.count()},
              {"evaluations", refinement->evaluations},
              {"stopped_by", planning::refinement_end_name(refinement->end)}};
  if (refinement->energy_before) result["energy_before_j"] = refinement->energy_before->value;
  if (refinement->energy_after) result["energy_after_j"] = refinement->energy_after->value;
  return result;
}

/// The travel times of routes with other numbers of legs; empty without refinement.
json leg_trade_json(const std::optional<planning::RefinementReport>& refinement) {
  json result = json::array();
  if (!refinement) return result;
  for (const planning::LegTrade& entry : refinement->trade) {
    result.push_back({{"legs", entry.legs}, {"travel_time_s", entry.travel_time.count()}});
  }
  return result;
}

std::optional<planning::RefinementReport> parse_refinement(const json& document) {
  const json& refinement = document.at("refinement");
  if (refinement.is_null()) return std::nullopt;
  planning::RefinementReport report{
      .before = core::Seconds{refinement.at("before_s").get<double>()},
      .after = core::Seconds{refinement.at("after_s").get<double>()},
      .evaluations = refinement.at("evaluations").get<std::int64_t>(),
      .end = planning::parse_refinement_end(refinement.at("stopped_by").get<std::string>())
                 .value_or(planning::RefinementEnd::converged)};
  if (refinement.contains("energy_before_j"))
    report.energy_before = core::Joules{refinement.at("energy_before_j").get<double>()};
  if (refinement.contains("energy_after_j"))
    report.energy_after = core::Joules{refinement.at("energy_after_j").get<double>()};
  for (const json& entry : document.at("leg_trade")) {
    report.trade.push_back({.legs = entry.at("legs").get<std::size_t>(),
                            .travel_time = core::Seconds{entry.at("travel_time_s").get<double>()}});
  }
  return report;
}

planning::Plan parse_members(const json& document) {
  planning::Plan plan;
  plan.method =
      planning::parse_method(document.at("method").get<std::string>()).value_or(planning::Method::astar);
  plan.vehicle = document.at("vehicle").get<std::string>();
  plan.departure = stored_time(document, "departure");
  plan.arrival = stored_time(document, "arrival");
  plan.distance = {document.at("distance_m").get<double>()};
  for (const auto& waypoint : document.at("waypoints")) plan.waypoints.push_back(parse_waypoint(waypoint));
  if (const json& order = document.at("via_order"); !order.is_null()) {
    plan.via_order =
        planning::ViaOrder{order.at("vias").get<std::vector<std::size_t>>(), order.at("exact").get<bool>()};
  }
  const json& search = document.at("search");
  plan.search = {.vertices = search.at("vertices").get<std::int64_t>(),
                 .edges = search.at("edges").get<std::int64_t>(),
                 .edge_evaluations = search.at("edge_evaluations").get<std::int64_t>(),
                 .expansions = search.at("expansions").get<std::int64_t>(),
                 .reinsertions = search.at("reinsertions").get<std::int64_t>(),
                 .cut_short = search.at("cut_short").get<bool>(),
                 .possible_gain = parse_possible_gain(search),
                 .duration = core::Seconds{search.at("seconds").get<double>()}};
  plan.refinement = parse_refinement(document);
  const json& clearances = document.at("clearances");
  const json& nearest = clearances.at("iceberg_id");
  plan.clearances = {.iceberg = metres_at(clearances, "iceberg_m"),
                     .nearest_iceberg = nearest.is_null() ? "" : nearest.get<std::string>(),
                     .land = metres_at(clearances, "land_m"),
                     .bottom = metres_at(clearances, "bottom_m")};
  plan.iceberg_encounters = stored_number(document, "iceberg_encounters");
  plan.passed_under = parse_passed_under(document);
  plan.encounter_trade = parse_encounter_trade(document);
  plan.surfacing = parse_surfacing(document);
  plan.uncertainty = parse_uncertainty_document(document.at("uncertainty"));
  plan.energy = parse_energy(document.at("energy"));
  plan.optimality_gap = stored_number(document, "optimality_gap");
  plan.optimality_gap_reason = document.at("optimality_gap_reason").get<std::string>();
  for (const auto& dataset : document.at("datasets")) plan.datasets.push_back(parse_dataset_ref(dataset));
  plan.messages = stored_messages(document);
  return plan;
}

json via_order_json(const std::optional<planning::ViaOrder>& order) {
  if (!order) return nullptr;
  return {{"vias", order->vias}, {"exact", order->exact}};
}

json change_json(const planning::Change& change) {
  const auto value = [](const planning::Change::Value& alternative) {
    return std::visit(
        [](const auto& held) -> json {
          using T = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<T, core::UtcTime>) {
            return core::iso8601(held);
          } else if constexpr (std::is_same_v<T, geo::LonLat>) {
            return json::array({document_degrees(held.lon_deg), document_degrees(held.lat_deg)});
          } else if constexpr (std::is_same_v<T, planning::Change::Nothing>) {
            return json();
          } else {
            return held;
          }
        },
        alternative);
  };
  json with = json::array();
  for (const planning::Change& other : change.with) with.push_back(change_json(other));
  return {{"input", change.input},
          {"from", value(change.from)},
          {"to", value(change.to)},
          {"text", change.text},
          {"with", std::move(with)}};
}

}  // namespace

json plan_document(const planning::Plan& plan, const std::string& plan_id, const std::string& name) {
  json waypoints = json::array();
  for (const auto& waypoint : plan.waypoints) {
    json object = waypoint_json(waypoint, waypoints.size());
    add_surfacing_state(plan.surfacing, waypoints.size(), object);
    waypoints.push_back(std::move(object));
  }
  json document{
      {"plan_id", plan_id.empty() ? json() : json(plan_id)},
      {"name", name},
      {"status", "ok"},
      {"method", planning::method_name(plan.method)},
      {"vehicle", plan.vehicle},
      {"departure", core::iso8601(plan.departure)},
      {"arrival", core::iso8601(plan.arrival)},
      {"travel_time_s", plan.travel_time().count()},
      {"distance_m", plan.distance.value},
      {"surfacing", surfacing_json(plan.surfacing)},
      {"iceberg_encounters", optional_number(plan.iceberg_encounters)},
      {"encounter_trade", encounter_trade_json(plan)},
      {"passed_under", passed_under_json(plan.passed_under)},
      {"energy_j", plan.energy ? json(plan.energy->use.total().value) : json()},
      {"energy", energy_json(plan.energy)},
      {"optimality_gap", optional_number(plan.optimality_gap)},
      {"optimality_gap_reason", plan.optimality_gap_reason},
      {"waypoints", std::move(waypoints)},
      {"via_order", via_order_json(plan.via_order)},
      {"uncertainty", plan.uncertainty ? uncertainty_document(*plan.uncertainty) : json()},
      {"search",
       {{"vertices", plan.search.vertices},
        {"edges", plan.search.edges},
        {"edge_evaluations", plan.search.edge_evaluations},
        {"expansions", plan.search.expansions},
        {"reinsertions", plan.search.reinsertions},
        {"cut_short", plan.search.cut_short},
        {"possible_gain_s", plan.search.possible_gain ? json(plan.search.possible_gain->count()) : json()},
        {"seconds", plan.search.duration.count()}}},
      {"refinement", refinement_json(plan.refinement)},
      {"leg_trade", leg_trade_json(plan.refinement)},
      {"clearances",
       {{"iceberg_m", optional_value(plan.clearances.iceberg)},
        {"iceberg_id",
         plan.clearances.nearest_iceberg.empty() ? json() : json(plan.clearances.nearest_iceberg)},
        {"land_m", optional_value(plan.clearances.land)},
        {"bottom_m", optional_value(plan.clearances.bottom)}}},
      {"datasets", dataset_refs_json(plan.datasets)}};
  tell(document, plan.messages);
  return document;
}

std::string plan_identity(const json& inputs, const planning::Plan& plan) {
  json told = plan_document(plan, "", "");
  for (const char* other : {"search", "dangers", "warnings", "optimality_gap_reason"}) told.erase(other);
  // These follow from the route and the data: a plan of an older version without them has the same id.
  if (!told["surfacing"].is_null())
    for (const char* derived : {"below_ice", "below_ice_m", "below_ice_s"}) told["surfacing"].erase(derived);
  told["clearances"].erase("iceberg_id");
  for (json& message : told["messages"]) {
    message.erase("text");
    if (message["rank"] == messages::rank_name(messages::Rank::note)) message.erase("values");
  }
  return "p" + sha256(inputs.dump() + "\n" + told.dump()).substr(0, 12);
}

json infeasible_document(const planning::Infeasible& infeasible, const ocean::Environment& environment) {
  json changes = json::array();
  for (const planning::Change& change : infeasible.changes) changes.push_back(change_json(change));
  std::vector<messages::Message> why{infeasible.why};
  why.insert(why.end(), infeasible.besides.begin(), infeasible.besides.end());
  json document{
      {"status", "infeasible"},
      {"reason", planning::reason_name(infeasible.reason)},
      {"at",
       {{"lon", document_degrees(infeasible.at.lon_deg)}, {"lat", document_degrees(infeasible.at.lat_deg)}}},
      {"when", core::iso8601(infeasible.when)},
      {"explanation", infeasible.explanation()},
      {"suggestion", infeasible.suggestion()},
      {"why", messages_json(why)},
      {"binding_constraint", planning::constraint_name(infeasible.binding)},
      {"smallest_change", changes.empty() ? json() : changes.front()},
      {"changes", std::move(changes)},
      {"changes_cut_short", infeasible.changes_cut_short},
      {"datasets", dataset_refs_json(environment.datasets)}};
  tell(document, environment.messages);
  return document;
}

planning::Plan parse_plan_document(const json& document) {
  try {
    return parse_members(with_later_members(document));
  } catch (const json::exception& error) {
    throw std::runtime_error{messages::store_text<"stored-plan-unreadable">(error.what())};
  }
}

std::vector<geo::LonLat> route_of(const json& document) {
  std::vector<geo::LonLat> route;
  for (const auto& waypoint : document.at("waypoints")) {
    route.push_back({waypoint.at("lon").get<double>(), waypoint.at("lat").get<double>()});
  }
  return route;
}

}  // namespace floeplan::codec
