#include "api/codec/inputs/plan_input_parts.hpp"
#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
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
    reader.refuse<"wrong-shape-found">(
        "/spacing_m", "a distance from 10 to 100000 m, or two as [along, across]", shown(*value));
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
  read_fields(reader, fields::alternative_fields(), request);
  read_fields(reader, fields::leg_fields(), request);
  read_fields(reader, fields::search_fields(), request);
  read_fields(reader, fields::encounter_fields(), request.icebergs);
}

void write_search(const planning::PlanRequest& request, json& inputs) {
  inputs["spacing_m"] = spacing_json(request);
  write_fields(fields::alternative_fields(), request, inputs);
  write_fields(fields::leg_fields(), request, inputs);
  write_fields(fields::search_fields(), request, inputs);
  write_fields(fields::encounter_fields(), request.icebergs, inputs);
}

}  // namespace floeplan::codec
