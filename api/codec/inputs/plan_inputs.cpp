#include "api/codec/inputs/plan_inputs.hpp"

#include <algorithm>

#include "api/codec/inputs/data_inputs.hpp"
#include "api/codec/inputs/ice_inputs.hpp"
#include "api/codec/inputs/plan_input_parts.hpp"
#include "api/codec/inputs/route_inputs.hpp"
#include "api/codec/inputs/uncertainty_inputs.hpp"
#include "api/codec/inputs/vehicle_inputs.hpp"
#include "api/codec/inputs/zone_inputs.hpp"
#include "api/codec/reading/input_fields.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/fields/request_fields.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/planning/cost/layout.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t max_vias = 50;
constexpr std::size_t max_remarks = 200;  // a mission file gives at most 100 messages
constexpr std::size_t longest_remark = 1000;

/// Reads what both processes share: vehicle, margin, data and name.
void read_common(InputReader& reader, planning::PlanRequest& request, repository::EnvironmentQuery& data,
                 std::string& name) {
  request.flight = read_vehicle(reader, request.vehicle);
  read_energy(reader, request.energy);
  reader.refuse_rest(request.energy.violations(request.vehicle));
  request.zones = read_areas(reader);
  read_under_ice(reader, request.under_ice);
  read_data(reader, data);
  read_iceberg_rules(reader, request.icebergs, data);
  read_fields(reader, fields::hold_fields(), request);
  name = reader.text("name").value_or("");
}

/// Reads the sentences in the member `remarks` and adds them to `warnings`; the answer repeats them.
void read_remarks(InputReader& reader, std::vector<std::string>& warnings) {
  const json* remarks = reader.member("remarks");
  if (remarks == nullptr) return;
  const bool texts =
      remarks->is_array() && remarks->size() <= max_remarks &&
      std::ranges::all_of(*remarks, [](const json& remark) {
        return remark.is_string() && remark.get_ref<const std::string&>().size() <= longest_remark;
      });
  if (!texts)
    return reader.refuse<"wrong-shape">("/remarks",
                                        "an array of at most 200 texts of at most 1000 bytes each");
  for (const json& remark : *remarks) warnings.push_back(remark.get<std::string>());
}

/// Reads goals from a file; without "from" the first of them is the start.
void read_goals(InputReader& reader, planning::PlanRequest& request, std::vector<std::string>& warnings) {
  if (reader.member("to") != nullptr || reader.member("via") != nullptr)
    reader.refuse<"goals-given-twice">("/goals_file");
  GivenRoute goals = read_file_route(reader, "goals_file");
  if (goals.places.size() > max_vias + 2) return reader.refuse<"too-many-goals">("/goals_file", max_vias);
  if (goals.places.size() < 2) return;
  request.from = goals.places.front();
  request.to = goals.places.back();
  request.via.assign(goals.places.begin() + 1, goals.places.end() - 1);
  warnings = std::move(goals.warnings);
}

void read_places(InputReader& reader, planning::PlanRequest& request) {
  reader.require("from", "the start as [longitude, latitude]");
  reader.require("to", "the goal as [longitude, latitude]");
  const auto from = reader.place("from");
  const auto to = reader.place("to");
  request.via = reader.places("via", 0, max_vias).value_or(std::vector<geo::LonLat>{});
  if (from) request.from = *from;
  if (to) request.to = *to;
  if (from && to && *from == *to && request.via.empty()) {
    reader.refuse<"goal-is-start">("/to");
  }
}

/// The area that a plan between the ends of a route would use. Evaluating a plan's route must give icebergs
/// the same drift, and the drift depends on the data of that area.
geo::BoundingBox area_of_a_plan(planning::PlanRequest request) {
  request.via.clear();
  return request.from == request.to ? geo::bounding_box(std::vector{request.from})
                                    : planning::cost::planning_area(request);
}

geo::BoundingBox around_stops(const planning::PlanRequest& request) {
  std::vector<geo::LonLat> stops{request.from, request.to};
  stops.insert(stops.end(), request.via.begin(), request.via.end());
  return geo::bounding_box(stops);
}

/// Areas of data are extended to this grid, so that similar requests read, and can cache, the same area.
constexpr double lattice_deg = 0.25;

void fill_data(const planning::PlanRequest& request, repository::EnvironmentQuery& data) {
  data.area = area_of_data(request);
  data.around_stops = around_stops(request);
  fill_period(request, data);
  data.dive_depth = request.vehicle.dive_depth;
}

/// Reads the inputs of an evaluation except the route.
void read_conditions(InputReader& reader, EvaluateInputs& inputs) {
  read_departure(reader, inputs.request);
  read_common(reader, inputs.request, inputs.data, inputs.name);
  reader.refuse_unknown();
}

json place_json(geo::LonLat place) { return json::array({place.lon_deg, place.lat_deg}); }

json places_json(const std::vector<geo::LonLat>& places) {
  json result = json::array();
  for (const auto& place : places) result.push_back(place_json(place));
  return result;
}

json common_json(const planning::PlanRequest& request, const repository::EnvironmentQuery& data,
                 const std::string& name) {
  json inputs{{"name", name}};
  write_vehicle(request.vehicle, inputs);
  write_energy(request.energy, inputs);
  inputs["areas"] = request.zones.empty() ? json() : areas_json(request.zones);
  write_under_ice(request.under_ice, inputs);
  write_data(data, inputs);
  write_iceberg_rules(request.icebergs, data, inputs);
  write_fields(fields::hold_fields(), request, inputs);
  return inputs;
}

}  // namespace

geo::BoundingBox area_of_data(const planning::PlanRequest& request) {
  return geo::on_lattice(planning::cost::planning_area(request), lattice_deg);
}

tl::expected<PlanInputs, core::Violations> parse_plan_inputs(const json& inputs) {
  InputReader reader{inputs};
  PlanInputs result;
  if (reader.member("goals_file") != nullptr) {
    read_goals(reader, result.request, result.warnings);
  } else {
    read_places(reader, result.request);
    if (reader.member("route_name") != nullptr)
      reader.refuse<"no-file-to-choose-in">("/route_name", "a file in \"goals_file\"");
  }
  read_remarks(reader, result.warnings);
  read_fields(reader, fields::order_fields(), result.request);
  read_departures(reader, result.request);
  read_common(reader, result.request, result.data, result.name);
  read_search(reader, result.request);
  result.request.uncertainty = read_uncertainty(reader);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  for (std::string& remark : reader.remarks()) result.warnings.push_back(std::move(remark));

  if (auto violations = result.request.violations(); !violations.empty()) {
    return tl::unexpected(std::move(violations));
  }
  fill_data(result.request, result.data);
  return result;
}

tl::expected<EvaluateInputs, core::Violations> parse_evaluate_inputs(const json& inputs) {
  InputReader reader{inputs};
  EvaluateInputs result;
  GivenRoute given = read_route(reader);
  read_remarks(reader, given.warnings);
  read_conditions(reader, result);
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());

  result.plan_id = std::move(given.plan_id);
  result.warnings = std::move(given.warnings);
  for (std::string& remark : reader.remarks()) result.warnings.push_back(std::move(remark));
  if (!result.plan_id) set_route(result, std::move(given.places));
  return result;
}

void cover_way(PlanInputs& inputs, const geo::BoundingBox& way) {
  constexpr core::Metres round_the_way{20'000.0};  // more than a simulated vehicle deviates from its route
  inputs.data.area =
      geo::united(inputs.data.area, geo::on_lattice(geo::grown(way, round_the_way), lattice_deg));
}

tl::expected<EvaluateInputs, core::Violations> parse_flight_inputs(const json& inputs,
                                                                   std::vector<geo::LonLat> route) {
  InputReader reader{inputs};
  EvaluateInputs result;
  read_conditions(reader, result);
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  set_route(result, std::move(route));
  return result;
}

void set_route(EvaluateInputs& inputs, std::vector<geo::LonLat> route) {
  inputs.route = std::move(route);
  inputs.request.from = inputs.route.front();
  inputs.request.to = inputs.route.back();
  inputs.request.via.assign(inputs.route.begin() + 1, inputs.route.end() - 1);
  fill_data(inputs.request, inputs.data);
  inputs.data.area =
      geo::united(inputs.data.area, geo::on_lattice(area_of_a_plan(inputs.request), lattice_deg));
}

json to_json(const PlanInputs& inputs) {
  const auto& request = inputs.request;
  json result = common_json(request, inputs.data, inputs.name);
  result["from"] = place_json(request.from);
  result["to"] = place_json(request.to);
  result["via"] = places_json(request.via);
  result["uncertainty"] = uncertainty_json(request.uncertainty);
  result["remarks"] = inputs.warnings;
  write_fields(fields::order_fields(), request, result);
  write_departures(request, result);
  write_search(request, result);
  return result;
}

json to_json(const EvaluateInputs& inputs) {
  json result = common_json(inputs.request, inputs.data, inputs.name);
  result["depart"] = core::iso8601(inputs.request.depart);
  result["remarks"] = inputs.warnings;
  if (inputs.plan_id) {
    result["plan_id"] = *inputs.plan_id;
  } else {
    result["route"] = places_json(inputs.route);
  }
  return result;
}

}  // namespace floeplan::codec
