#include "api/codec/inputs/plan_input_parts.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::string_view departure_time =
    "the time of departure in ISO 8601 with its zone, as 2026-11-20T06:00:00Z";

json time_json(const std::optional<core::UtcTime>& time) {
  return time ? json(core::iso8601(*time)) : json();
}

/// The duration in seconds, as "PT3600S". So equal durations give equal texts, in whatever notation the request
/// gave them.
std::string duration_text(core::Seconds duration) { return "PT" + json(duration.count()).dump() + "S"; }

}  // namespace

void read_departure(InputReader& reader, planning::PlanRequest& request) {
  reader.require("depart", departure_time);
  request.depart = reader.time("depart").value_or(core::UtcTime{});
}

void read_departures(InputReader& reader, planning::PlanRequest& request) {
  auto& departures = request.departures;
  departures.until = reader.time("depart_until");
  departures.arrive_by = reader.time("arrive_by");
  if (const auto step = reader.duration("depart_step")) {
    departures.step = *step;
    if (reader.member("depart_until") == nullptr) {
      reader.refuse<"step-without-window">("/depart_step");
    }
  }
  if (!departures.arrive_by) return read_departure(reader, request);
  request.depart = reader.time("depart").value_or(*departures.arrive_by - longest_mission);
}

void write_departures(const planning::PlanRequest& request, json& inputs) {
  inputs["depart"] = core::iso8601(request.depart);
  inputs["depart_until"] = time_json(request.departures.until);
  inputs["depart_step"] = request.departures.until ? json(duration_text(request.departures.step)) : json();
  inputs["arrive_by"] = time_json(request.departures.arrive_by);
}

void fill_period(const planning::PlanRequest& request, repository::EnvironmentQuery& data) {
  data.depart = request.depart;
  if (request.departures.until) data.until = {"depart_until", *request.departures.until};
  if (request.departures.arrive_by) {
    data.until = {"arrive_by", *request.departures.arrive_by};
    data.may_begin_later = true;
  }
}

}  // namespace floeplan::codec
