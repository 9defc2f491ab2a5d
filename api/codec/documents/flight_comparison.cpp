#include "api/codec/documents/flight_comparison.hpp"

#include "api/codec/documents/vehicle_axes_document.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "engine/core/utc_text.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using simulation::Compared;
using simulation::DragOf;
using simulation::SegmentComparison;

void read_log(InputReader& reader, const json& value, const std::string& pointer,
              std::vector<GliderLog>& logs) {
  InputReader members{value, pointer};
  members.require("name", "the log's name");
  members.require("text", "the log itself");
  const auto name = members.text("name");
  const auto text = members.text("text", longest_log);
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
  if (!name || !text) return;
  auto dives = simulation::read_glider_log(*text);
  if (!dives) return reader.refuse_all(pointer, dives.error());
  logs.push_back({*name, *text, std::move(*dives)});
}

std::vector<GliderLog> read_logs(InputReader& reader) {
  std::vector<GliderLog> logs;
  reader.require("files", "logs of a Slocum, each with \"name\" and \"text\"");
  const json* value = reader.member("files");
  if (value == nullptr) return logs;
  if (!value->is_array() || value->empty() || value->size() > most_logs) {
    reader.refuse<"wrong-shape">("/files", "an array of 1 to 100 logs, each with \"name\" and \"text\"");
    return logs;
  }
  for (std::size_t i = 0; i < value->size(); ++i)
    read_log(reader, (*value)[i], "/files/" + std::to_string(i), logs);
  return logs;
}

DragOf read_drag(InputReader& reader) {
  const auto drag = reader.text("drag");
  if (drag && *drag != "log" && *drag != "profile")
    reader.refuse<"wrong-shape">("/drag", "log, the one that the log's rates of depth tell, or profile");
  return drag == "profile" ? DragOf::profile : DragOf::log;
}

json pair_of(const Compared& compared) {
  return {{"logged", compared.logged},
          {"simulated", compared.simulated},
          {"deviation_pct", 100.0 * compared.deviation_share()}};
}

}  // namespace

tl::expected<vehicle::GliderProfile, core::Violation> compared_vehicle(const std::string& name) {
  if (auto found = vehicle::find_profile(name)) return *found;
  std::string known;
  for (const auto& profile : vehicle::known_profiles()) known += (known.empty() ? "" : ", ") + profile.name;
  return tl::unexpected(messages::fault<"unknown-vehicle">("/vehicle", name, known));
}

tl::expected<CompareFlightInputs, core::Violations> parse_compare_flight_inputs(const json& inputs) {
  InputReader reader{inputs};
  CompareFlightInputs result;
  result.logs = read_logs(reader);
  const auto vehicle = compared_vehicle(reader.text("vehicle").value_or(usual_compared_vehicle));
  if (vehicle) {
    result.vehicle = *vehicle;
  } else {
    reader.refuse_all("", {vehicle.error()});
  }
  result.drag = read_drag(reader);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return result;
}

json to_json(const CompareFlightInputs& inputs) {
  json files = json::array();
  for (const GliderLog& log : inputs.logs) files.push_back({{"name", log.name}, {"text", log.text}});
  return {{"files", std::move(files)},
          {"vehicle", inputs.vehicle.name},
          {"drag", inputs.drag == DragOf::log ? "log" : "profile"}};
}

simulation::ComparisonSummary summary_of(std::span<const ComparedDive> dives) {
  std::vector<SegmentComparison> comparisons;
  for (const ComparedDive& dive : dives) comparisons.push_back(dive.compared);
  return simulation::summary_of(comparisons);
}

json comparison_document(std::span<const ComparedDive> dives) {
  json listed = json::array();
  for (const ComparedDive& dive : dives) {
    const SegmentComparison& compared = dive.compared;
    listed.push_back({{"file", dive.file},
                      {"dived", core::iso8601(dive.logged.dived)},
                      {"under_water_s", pair_of(compared.under_water_s)},
                      {"dives", pair_of(compared.dives)},
                      {"speed_through_water_m_s", pair_of(compared.speed_m_s)},
                      {"over_ground_m", pair_of(compared.over_ground_m)},
                      {"positions_apart_m", compared.apart_m},
                      {"positions_apart_pct", 100.0 * compared.apart_share},
                      {"parasite_drag", compared.parasite_drag},
                      {"trim_cm3", 1e6 * dive.logged.trim().value},
                      {"currents_turned_from", vehicle_axes_document(dive.logged.turned_from)}});
    if (!dive.logged.positions_read.empty()) listed.back()["positions_read"] = dive.logged.positions_read;
  }
  const simulation::ComparisonSummary summary = summary_of(dives);
  return {{"dives", std::move(listed)},
          {"median",
           {{"under_water_pct", 100.0 * summary.under_water_share},
            {"dives_pct", 100.0 * summary.dives_share},
            {"speed_pct", 100.0 * summary.speed_share},
            {"positions_apart_pct", 100.0 * summary.apart_share},
            {"parasite_drag", summary.parasite_drag},
            {"within_a_tenth", summary.within_a_tenth()}}}};
}

}  // namespace floeplan::codec
