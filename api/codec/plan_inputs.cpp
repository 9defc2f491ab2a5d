#include "api/codec/plan_inputs.hpp"

#include <nlohmann/json.hpp>

#include "api/codec/input_reader.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/planning/layout.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using How = repository::DatasetChoice::How;

constexpr std::size_t max_vias = 50;
constexpr std::size_t max_route_places = 10'000;
constexpr std::size_t max_ensemble = 64;

/// "newest", "none", an id, or (where `several`) an array of ids.
repository::DatasetChoice read_choice(InputReader& reader, const std::string& key, bool several) {
  const json* value = reader.member(key);
  if (value == nullptr) return {};
  const std::string rule = several ? "must be \"newest\", \"none\", an id or an array of ids, not "
                                   : "must be \"newest\", \"none\" or an id, not ";
  if (value->is_string()) {
    const auto& text = value->get_ref<const std::string&>();
    if (text == "newest") return {How::newest, {}};
    if (text == "none") return {How::none, {}};
    return {How::named, {{text}}};
  }
  repository::DatasetChoice choice{How::named, {}};
  if (!several || !value->is_array() || value->empty() || value->size() > max_ensemble) {
    reader.refuse("/" + key, rule + shown(*value));
    return {};
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    const json& id = (*value)[i];
    if (id.is_string()) {
      choice.ids.push_back({id.get<std::string>()});
    } else {
      reader.refuse("/" + key + "/" + std::to_string(i), "must be the id of a dataset, not " + shown(id));
    }
  }
  return choice;
}

/// What both processes share: departure, vehicle, margin, data and name.
void read_common(InputReader& reader, planning::PlanRequest& request, repository::EnvironmentQuery& data,
                 std::string& name) {
  reader.require("depart",
                 "is required: the time of departure in ISO 8601 with its zone, as 2026-11-20T06:00:00Z");
  request.depart = reader.time("depart").value_or(core::UtcTime{});

  request.vehicle = vehicle::known_profiles().front();
  if (const auto vehicle_name = reader.text("vehicle")) {
    if (const auto profile = vehicle::find_profile(*vehicle_name)) {
      request.vehicle = *profile;
    } else {
      std::string names;
      for (const auto& profile_known : vehicle::known_profiles()) {
        names += (names.empty() ? "" : ", ") + profile_known.name;
      }
      reader.refuse("/vehicle", "must be one of " + names + ", not \"" + *vehicle_name + "\"");
    }
  }
  if (const auto speed = reader.number("speed_m_s", {0.05, 5.0}))
    request.vehicle.speed_through_water = {*speed};
  if (const auto depth = reader.number("dive_depth_m", {1.0, request.vehicle.depth_rating.value})) {
    request.vehicle.dive_depth = {*depth};
  }
  if (const auto margin = reader.number("margin_m", {0.0, 100'000.0})) request.iceberg_margin = {*margin};

  data.currents = read_choice(reader, "currents", true);
  data.steady = reader.boolean("steady").value_or(false);
  data.bathymetry = read_choice(reader, "bathymetry", false);
  data.icebergs = read_choice(reader, "icebergs", false);
  data.icebergs_as_of = reader.time("icebergs_as_of");
  data.coastline = read_choice(reader, "coastline", false);
  name = reader.text("name").value_or("");
}

void read_spacing(InputReader& reader, planning::PlanRequest& request) {
  constexpr double least_m = 10.0;
  constexpr double most_m = 100'000.0;
  const auto valid = [&](const json& value) {
    return value.is_number() && value.get<double>() >= least_m && value.get<double>() <= most_m;
  };
  const json* value = reader.member("spacing_m");
  if (value == nullptr) return;
  if (valid(*value)) {
    request.spacing_along = core::Metres{value->get<double>()};
  } else if (value->is_array() && value->size() == 2 && valid((*value)[0]) && valid((*value)[1])) {
    request.spacing_along = core::Metres{(*value)[0].get<double>()};
    request.spacing_across = core::Metres{(*value)[1].get<double>()};
  } else {
    reader.refuse("/spacing_m",
                  "must be a distance from 10 to 100000 m, or two as [along, across], not " + shown(*value));
  }
}

void read_search(InputReader& reader, planning::PlanRequest& request) {
  read_spacing(reader, request);
  if (const auto sectors = reader.integer("sectors", 1, 5)) request.sectors = *sectors;
  if (const auto text = reader.text("method")) {
    if (const auto method = planning::parse_method(*text)) {
      request.method = *method;
    } else {
      reader.refuse("/method", "must be tve, dijkstra, astar, frozen or direct, not \"" + *text + "\"");
    }
  }
  if (const auto objective = reader.text("objective"); objective && *objective != "time") {
    reader.refuse("/objective", "must be \"time\", the only objective so far, not \"" + *objective + "\"");
  }
  request.max_waypoints = reader.integer("max_waypoints", 2, 10'000);
  if (const auto refine = reader.boolean("refine")) request.refine = *refine;
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

void fill_data(const planning::PlanRequest& request, repository::EnvironmentQuery& data) {
  data.area = planning::planning_area(request);
  data.depart = request.depart;
  data.dive_depth = request.vehicle.dive_depth;
}

/// The positions of a route given as GeoJSON or as a bare array; notes what is wrong with it.
void read_route(InputReader& reader, EvaluateInputs& inputs) {
  const json* route = reader.member("route");
  inputs.plan_id = reader.text("plan_id");
  if ((route != nullptr) == (reader.member("plan_id") != nullptr)) {
    reader.refuse("/route", "is required, or else \"plan_id\", and only one of them");
    return;
  }
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

json choice_json(const repository::DatasetChoice& choice) {
  if (choice.how == How::newest) return "newest";
  if (choice.how == How::none) return "none";
  if (choice.ids.size() == 1) return choice.ids.front().value;
  json ids = json::array();
  for (const auto& id : choice.ids) ids.push_back(id.value);
  return ids;
}

json place_json(geo::LonLat place) { return json::array({place.lon_deg, place.lat_deg}); }

json places_json(const std::vector<geo::LonLat>& places) {
  json result = json::array();
  for (const auto& place : places) result.push_back(place_json(place));
  return result;
}

json common_json(const planning::PlanRequest& request, const repository::EnvironmentQuery& data,
                 const std::string& name) {
  return {{"depart", core::iso8601(request.depart)},
          {"vehicle", request.vehicle.name},
          {"speed_m_s", request.vehicle.speed_through_water.value},
          {"dive_depth_m", request.vehicle.dive_depth.value},
          {"margin_m", request.iceberg_margin.value},
          {"currents", choice_json(data.currents)},
          {"steady", data.steady},
          {"bathymetry", choice_json(data.bathymetry)},
          {"icebergs", choice_json(data.icebergs)},
          {"icebergs_as_of", data.icebergs_as_of ? json(core::iso8601(*data.icebergs_as_of)) : json()},
          {"coastline", choice_json(data.coastline)},
          {"name", name}};
}

json spacing_json(const planning::PlanRequest& request) {
  if (!request.spacing_along) return nullptr;
  if (!request.spacing_across) return request.spacing_along->value;
  return json::array({request.spacing_along->value, request.spacing_across->value});
}

}  // namespace

tl::expected<PlanInputs, core::Violations> parse_plan_inputs(const json& inputs) {
  InputReader reader{inputs};
  PlanInputs result;
  read_places(reader, result.request);
  read_common(reader, result.request, result.data, result.name);
  read_search(reader, result.request);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());

  if (auto violations = result.request.violations(); !violations.empty()) {
    for (auto& violation : violations) {
      if (!violation.field.starts_with('/')) violation.field.insert(0, "/");
    }
    return tl::unexpected(std::move(violations));
  }
  fill_data(result.request, result.data);
  return result;
}

tl::expected<EvaluateInputs, core::Violations> parse_evaluate_inputs(const json& inputs) {
  InputReader reader{inputs};
  EvaluateInputs result;
  read_route(reader, result);
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
  result["spacing_m"] = spacing_json(request);
  result["sectors"] = request.sectors;
  result["method"] = planning::method_name(request.method);
  result["objective"] = "time";
  result["max_waypoints"] = request.max_waypoints ? json(*request.max_waypoints) : json();
  result["refine"] = request.refine;
  return result;
}

json to_json(const EvaluateInputs& inputs) {
  json result = common_json(inputs.request, inputs.data, inputs.name);
  if (inputs.plan_id) {
    result["plan_id"] = *inputs.plan_id;
  } else {
    result["route"] = places_json(inputs.route);
  }
  return result;
}

}  // namespace floeplan::codec
