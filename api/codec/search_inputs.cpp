#include "api/codec/search_inputs.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

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

json spacing_json(const planning::PlanRequest& request) {
  if (!request.spacing_along) return nullptr;
  if (!request.spacing_across) return request.spacing_along->value;
  return json::array({request.spacing_along->value, request.spacing_across->value});
}

}  // namespace

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
  request.max_waypoints = reader.integer("max_waypoints", 2, 10'000);
  if (const auto longest = reader.number("max_leg_m", {100.0, 5e6})) request.max_leg = core::Metres{*longest};
  if (const auto refine = reader.boolean("refine")) request.refine = *refine;
  if (const auto most = reader.number("refine_seconds", {0.05, 60.0}))
    request.refine_time = core::Seconds{*most};
  if (const auto gap = reader.boolean("optimality_gap")) request.optimality_gap = *gap;
  if (const auto weight = reader.number("encounter_weight_s", {0.0, 1e7}))
    request.icebergs.encounter_weight = core::Seconds{*weight};
}

void write_search(const planning::PlanRequest& request, json& inputs) {
  inputs["spacing_m"] = spacing_json(request);
  inputs["sectors"] = request.sectors;
  inputs["method"] = planning::method_name(request.method);
  inputs["max_waypoints"] = request.max_waypoints ? json(*request.max_waypoints) : json();
  inputs["max_leg_m"] = request.max_leg ? json(request.max_leg->value) : json();
  inputs["refine"] = request.refine;
  inputs["refine_seconds"] = request.refine_time.count();
  inputs["optimality_gap"] = request.optimality_gap;
  inputs["encounter_weight_s"] = request.icebergs.encounter_weight.count();
}

}  // namespace floeplan::codec
