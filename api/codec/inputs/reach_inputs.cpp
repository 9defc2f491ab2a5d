#include "api/codec/inputs/reach_inputs.hpp"

#include "api/codec/inputs/data_inputs.hpp"
#include "api/codec/inputs/ice_inputs.hpp"
#include "api/codec/inputs/vehicle_inputs.hpp"
#include "api/codec/inputs/zone_inputs.hpp"
#include "api/codec/reading/input_fields.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/fields/request_fields.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using planning::IsochroneRequest;
using Direction = IsochroneRequest::Direction;

constexpr double most_hours = IsochroneRequest::longest_span.count() / 3600.0;

/// Reads place and time of one direction; a missing member or a wrong combination is a violation.
void read_direction(InputReader& reader, IsochroneRequest& request) {
  const bool from = reader.member("from") != nullptr;
  const bool to = reader.member("to") != nullptr;
  const auto start = reader.place("from");
  const auto goal = reader.place("to");
  const auto depart = reader.time("depart");
  const auto arrive_by = reader.time("arrive_by");
  if (from == to) {
    if (from) {
      reader.refuse<"given-with-another">("/from", "\"to\"");
    } else {
      reader.refuse<"required-or-instead">("/from", "\"to\"");
    }
    return;
  }
  request.direction = from ? Direction::from : Direction::to;
  request.place = (from ? start : goal).value_or(geo::LonLat{});
  request.time = (from ? depart : arrive_by).value_or(core::UtcTime{});
  if (from) {
    reader.require_with("\"from\"", "depart", "the time of departure in ISO 8601 with its zone");
    if (reader.member("arrive_by") != nullptr)
      reader.refuse<"belongs-to-another">("/arrive_by", "to", "from");
  } else {
    reader.require_with("\"to\"", "arrive_by", "the time of arrival in ISO 8601 with its zone");
    if (reader.member("depart") != nullptr) reader.refuse<"belongs-to-another">("/depart", "from", "to");
  }
}

void read_hours(InputReader& reader, IsochroneRequest& request) {
  reader.require("hours", "one number of hours or several, as [6, 12, 24]");
  const json* value = reader.member("hours");
  if (value == nullptr) return;
  const json hours = value->is_array() ? *value : json::array({*value});
  if (hours.empty() || hours.size() > IsochroneRequest::most_spans) {
    reader.refuse<"not-so-many-times">("/hours", IsochroneRequest::most_spans);
    return;
  }
  for (std::size_t i = 0; i < hours.size(); ++i) {
    const bool valid =
        hours[i].is_number() && hours[i].get<double>() > 0.0 && hours[i].get<double>() <= most_hours;
    if (valid) {
      request.spans.emplace_back(3600.0 * hours[i].get<double>());
    } else {
      reader.refuse<"wrong-shape-found">(value->is_array() ? "/hours/" + std::to_string(i) : "/hours",
                                         "a number of hours above 0 and at most " + json(most_hours).dump(),
                                         shown(hours[i]));
    }
  }
}

}  // namespace

tl::expected<ReachInputs, core::Violations> parse_reach_inputs(const json& inputs) {
  InputReader reader{inputs};
  ReachInputs result;
  IsochroneRequest& request = result.request;
  read_direction(reader, request);
  read_hours(reader, request);
  read_vehicle(reader, request.vehicle);
  read_fields(reader, fields::isochrone_grid_fields(), request);
  request.zones = read_areas(reader);
  read_data(reader, result.data);
  read_iceberg_rules(reader, request.icebergs, result.data);
  read_passing_under_ice(reader, request.under_ice);
  result.name = reader.text("name").value_or("");
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  result.warnings = reader.remarks();
  if (auto violations = request.violations(); !violations.empty())
    return tl::unexpected(std::move(violations));

  result.data.area = planning::reach_area(request);
  result.data.depart = request.begin();
  result.data.until = {"hours", request.end()};
  result.data.dive_depth = request.vehicle.dive_depth;
  return result;
}

json to_json(const ReachInputs& inputs) {
  const IsochroneRequest& request = inputs.request;
  const bool from = request.direction == Direction::from;
  json hours = json::array();
  for (const core::Seconds span : request.spans) hours.push_back(span.count() / 3600.0);
  json result{{from ? "from" : "to", json::array({request.place.lon_deg, request.place.lat_deg})},
              {from ? "depart" : "arrive_by", core::iso8601(request.time)},
              {"hours", std::move(hours)},
              {"areas", request.zones.empty() ? json() : areas_json(request.zones)},
              {"name", inputs.name}};
  write_fields(fields::isochrone_grid_fields(), request, result);
  result["spacing_m"] = request.step().value;
  write_vehicle(request.vehicle, result);
  write_data(inputs.data, result);
  write_iceberg_rules(request.icebergs, inputs.data, result);
  write_passing_under_ice(request.under_ice, result);
  return result;
}

}  // namespace floeplan::codec
