#include "api/codec/plan_inputs.hpp"

#include <nlohmann/json.hpp>

#include "api/codec/data_inputs.hpp"
#include "api/codec/departure_inputs.hpp"
#include "api/codec/energy_inputs.hpp"
#include "api/codec/iceberg_inputs.hpp"
#include "api/codec/input_reader.hpp"
#include "api/codec/route_file.hpp"
#include "api/codec/search_inputs.hpp"
#include "api/codec/uncertainty_inputs.hpp"
#include "api/codec/under_ice_inputs.hpp"
#include "api/codec/vehicle_inputs.hpp"
#include "api/codec/zone_inputs.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/planning/layout.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t max_vias = 50;
constexpr std::size_t max_route_places = 10'000;

/// What both processes share: vehicle, margin, data and name.
void read_common(InputReader& reader, planning::PlanRequest& request, repository::EnvironmentQuery& data,
                 std::string& name) {
  read_vehicle(reader, request.vehicle);
  read_energy(reader, request.energy);
  for (const core::Violation& violation : request.energy.violations(request.vehicle)) {
    if (!reader.refused(violation.field)) reader.refuse(violation.field, violation.rule);
  }
  request.zones = read_areas(reader);
  read_under_ice(reader, request.under_ice);
  read_data(reader, data);
  read_iceberg_rules(reader, request.icebergs, data);
  name = reader.text("name").value_or("");
}

/// A file that came with the request, as {"name": ..., "text": ...}: its places, or what is wrong with it.
std::optional<RouteFile> read_file(InputReader& reader, const std::string& key) {
  const json* file = reader.member(key);
  if (file == nullptr) return std::nullopt;
  const auto text_at = [&](const char* name) {
    return file->is_object() && file->contains(name) && (*file)[name].is_string();
  };
  if (!text_at("name") || !text_at("text") || file->size() != 2) {
    reader.refuse("/" + key, "must be an object of a file's \"name\" and its \"text\"");
    return std::nullopt;
  }
  auto read =
      read_route_file((*file)["name"].get<std::string>(), (*file)["text"].get_ref<const std::string&>());
  if (read) return std::move(*read);
  for (const core::Violation& violation : read.error()) {
    reader.refuse("/" + key, violation.field + ": " + violation.rule);
  }
  return std::nullopt;
}

/// Goals from a file; without "from" the first of them is the start.
void read_goals(InputReader& reader, planning::PlanRequest& request, std::vector<std::string>& warnings) {
  auto goals = read_file(reader, "goals_file");
  if (reader.member("to") != nullptr || reader.member("via") != nullptr)
    reader.refuse("/goals_file", "takes the place of \"to\" and \"via\"; give one or the other");
  const auto from = reader.place("from");
  if (!goals) return;
  if (from) goals->places.insert(goals->places.begin(), *from);
  if (goals->places.size() < 2 || goals->places.size() > max_vias + 2) {
    reader.refuse("/goals_file",
                  "must hold one goal besides the start at least, and at most 50 on the way to it");
    return;
  }
  request.from = goals->places.front();
  request.to = goals->places.back();
  request.via.assign(goals->places.begin() + 1, goals->places.end() - 1);
  warnings = std::move(goals->warnings);
}

void read_places(InputReader& reader, planning::PlanRequest& request) {
  reader.require("from", "is required: the start as [longitude, latitude]");
  reader.require("to", "is required: the goal as [longitude, latitude]");
  const auto from = reader.place("from");
  const auto to = reader.place("to");
  request.via = reader.places("via", 0, max_vias).value_or(std::vector<geo::LonLat>{});
  if (from) request.from = *from;
  if (to) request.to = *to;
  if (from && to && *from == *to && request.via.empty()) {
    reader.refuse("/to",
                  "must differ from \"from\"; a route that returns to its start needs a place in \"via\"");
  }
}

void read_via_order(InputReader& reader, planning::PlanRequest& request) {
  if (const auto order = reader.text("via_order")) {
    request.via_in_best_order = *order == "best";
    if (*order != "best" && *order != "given") {
      reader.refuse("/via_order", "must be \"given\" or \"best\", not \"" + *order + "\"");
    }
  }
}

void fill_data(const planning::PlanRequest& request, repository::EnvironmentQuery& data) {
  data.area = planning::planning_area(request);
  fill_period(request, data);
  data.dive_depth = request.vehicle.dive_depth;
}

/// The places of a file, from the start where that is given.
void read_route_from_file(InputReader& reader, EvaluateInputs& inputs) {
  auto file = read_file(reader, "route_file");
  const auto from = reader.place("from");
  if (!file) return;
  if (from) file->places.insert(file->places.begin(), *from);
  if (file->places.size() < 2) {
    reader.refuse("/route_file", "must hold two places at least, or one and \"from\"");
    return;
  }
  inputs.route = std::move(file->places);
  inputs.warnings = std::move(file->warnings);
}

/// The positions of a route given as GeoJSON or as a bare array; notes what is wrong with it.
void read_route(InputReader& reader, EvaluateInputs& inputs) {
  const json* route = reader.member("route");
  inputs.plan_id = reader.text("plan_id");
  const bool from_file = reader.member("route_file") != nullptr;
  if ((route != nullptr) + (reader.member("plan_id") != nullptr) + from_file != 1) {
    reader.refuse("/route", "is required, or else \"plan_id\" or \"route_file\", and only one of them");
    return;
  }
  if (from_file) return read_route_from_file(reader, inputs);
  if (route == nullptr) return;
  std::string pointer = "/route";
  if (route->is_object() && route->value("type", json{}) == "Feature" && route->contains("geometry")) {
    route = &route->at("geometry");
    pointer += "/geometry";
  }
  if (route->is_object()) {
    if (route->value("type", json{}) != "LineString" || !route->contains("coordinates")) {
      reader.refuse(pointer, "must be a GeoJSON LineString or an array of positions");
      return;
    }
    route = &route->at("coordinates");
    pointer += "/coordinates";
  }
  if (auto places = reader.places(*route, pointer, 2, max_route_places)) inputs.route = std::move(*places);
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
  return inputs;
}

}  // namespace

tl::expected<PlanInputs, core::Violations> parse_plan_inputs(const json& inputs) {
  InputReader reader{inputs};
  PlanInputs result;
  if (reader.member("goals_file") != nullptr) {
    read_goals(reader, result.request, result.warnings);
  } else {
    read_places(reader, result.request);
  }
  read_via_order(reader, result.request);
  read_departures(reader, result.request);
  read_common(reader, result.request, result.data, result.name);
  read_search(reader, result.request);
  result.request.uncertainty = read_uncertainty(reader);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());

  if (auto violations = result.request.violations(); !violations.empty()) {
    return tl::unexpected(std::move(violations));
  }
  fill_data(result.request, result.data);
  return result;
}

tl::expected<EvaluateInputs, core::Violations> parse_evaluate_inputs(const json& inputs) {
  InputReader reader{inputs};
  EvaluateInputs result;
  read_route(reader, result);
  read_departure(reader, result.request);
  read_common(reader, result.request, result.data, result.name);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());

  if (!result.route.empty()) set_route(result, std::vector<geo::LonLat>{result.route});
  return result;
}

void set_route(EvaluateInputs& inputs, std::vector<geo::LonLat> route) {
  inputs.route = std::move(route);
  inputs.request.from = inputs.route.front();
  inputs.request.to = inputs.route.back();
  inputs.request.via.assign(inputs.route.begin() + 1, inputs.route.end() - 1);
  fill_data(inputs.request, inputs.data);
}

json to_json(const PlanInputs& inputs) {
  const auto& request = inputs.request;
  json result = common_json(request, inputs.data, inputs.name);
  result["from"] = place_json(request.from);
  result["to"] = place_json(request.to);
  result["via"] = places_json(request.via);
  result["uncertainty"] = uncertainty_json(request.uncertainty);
  result["via_order"] = request.via_in_best_order ? "best" : "given";
  write_departures(request, result);
  write_search(request, result);
  return result;
}

json to_json(const EvaluateInputs& inputs) {
  json result = common_json(inputs.request, inputs.data, inputs.name);
  result["depart"] = core::iso8601(inputs.request.depart);
  if (inputs.plan_id) {
    result["plan_id"] = *inputs.plan_id;
  } else {
    result["route"] = places_json(inputs.route);
  }
  return result;
}

}  // namespace floeplan::codec
