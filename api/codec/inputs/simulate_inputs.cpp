#include "api/codec/inputs/simulate_inputs.hpp"

#include <algorithm>
#include <array>

#include "api/codec/inputs/data_inputs.hpp"
#include "api/codec/inputs/sensor_inputs.hpp"
#include "api/codec/reading/input_limits.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/fields/limits.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr int tracks_unless_told = 10;
constexpr std::size_t most_files = 100;
constexpr std::size_t longest_file = 1 << 20;

constexpr std::array data_keys{"currents",   "steady", "tides",    "tides_mode",
                               "bathymetry", "ice",    "icebergs", "icebergs_as_of"};

std::vector<SimulatedFile> read_files(InputReader& reader) {
  std::vector<SimulatedFile> files;
  const json* value = reader.member("mission_files");
  if (value == nullptr) return files;
  if (!value->is_array() || value->empty() || value->size() > most_files) {
    reader.refuse<"wrong-shape">("/mission_files",
                                 "an array of 1 to 100 files, each with \"name\" and \"text\"");
    return files;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    InputReader file{(*value)[i], "/mission_files/" + std::to_string(i)};
    file.require("name", "the file's name");
    file.require("text", "what the file holds");
    const auto name = file.text("name");
    const auto text = file.text("text", longest_file);
    file.refuse_unknown();
    reader.refuse_all("", file.violations());
    if (name && text) files.push_back({*name, *text});
  }
  return files;
}

void read_current_error(InputReader& reader, simulation::CurrentErrorSettings& error) {
  const json* value = reader.member("current_error");
  if (value == nullptr) return;
  InputReader members{*value, "/current_error"};
  if (const auto rms = members.number("rms_m_s", any_number)) error.rms = {*rms};
  if (const auto length = members.number("length_scale_m", any_number)) error.length_scale = {*length};
  if (const auto depth = members.number("depth_scale_m", any_number)) error.depth_scale = {*depth};
  if (const auto time = members.number("time_scale_s", any_number)) error.time_scale = core::Seconds{*time};
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
  if (members.violations().empty()) reader.refuse_all("", error.violations());
}

json current_error_json(const simulation::CurrentErrorSettings& error) {
  return {{"rms_m_s", error.rms.value},
          {"length_scale_m", error.length_scale.value},
          {"depth_scale_m", error.depth_scale.value},
          {"time_scale_s", error.time_scale.count()}};
}

void read_navigation(InputReader& reader, simulation::NavigationErrors& errors) {
  const json* value = reader.member("navigation");
  if (value == nullptr) return;
  InputReader members{*value, "/navigation"};
  if (const auto compass = members.number("compass_sigma_deg", {0.0, 45.0}))
    errors.compass = {core::degrees_to_radians(*compass)};
  if (const auto share = members.number("speed_sigma_share", {0.0, 0.5})) errors.speed_share = *share;
  if (const auto fix = members.number("fix_sigma_m", {0.0, 1000.0})) errors.fix = {*fix};
  if (const auto current = members.number("current_sigma_m_s", {0.0, 2.0})) errors.current = {*current};
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
}

json navigation_json(const simulation::NavigationErrors& errors) {
  return {{"compass_sigma_deg", core::radians_to_degrees(errors.compass.value)},
          {"speed_sigma_share", errors.speed_share},
          {"fix_sigma_m", errors.fix.value},
          {"current_sigma_m_s", errors.current.value}};
}

/// Reads the choice of other data. It is checked like any choice of data, but only members in the request are
/// kept.
void read_other_data(InputReader& reader, SimulateInputs& result) {
  repository::EnvironmentQuery checked;
  json given = json::object();
  for (const char* key : data_keys) {
    if (const json* value = reader.member(key)) given[key] = *value;
  }
  InputReader of_data{given};
  read_data(of_data, checked);
  of_data.refuse_unknown();
  reader.refuse_all("", of_data.violations());
  result.data = std::move(given);
}

}  // namespace

tl::expected<SimulateInputs, core::Violations> parse_simulate_inputs(const json& inputs) {
  InputReader reader{inputs};
  SimulateInputs result;
  reader.require("plan_id", "the id of the stored plan to fly");
  result.plan_id = reader.text("plan_id").value_or("");
  result.mission_files = read_files(reader);
  result.vehicle = reader.text("vehicle");
  result.runs = reader.integer("runs", 1, most_runs).value_or(result.runs);
  result.seed = static_cast<std::uint64_t>(reader.integer("seed", 0, fields::largest_seed).value_or(1));
  result.tracks =
      std::min(result.runs, reader.integer("tracks", 0, most_tracks).value_or(tracks_unless_told));
  result.avoidance = reader.boolean("avoidance").value_or(result.avoidance);
  read_current_error(reader, result.current_error);
  result.sonar = read_sonar(reader, "sonar");
  result.altimeter = read_altimeter(reader, "altimeter");
  result.adcp = read_adcp(reader, "adcp");
  read_navigation(reader, result.flight.navigation);
  if (const auto longest = reader.number("longest_s", {60.0, 90.0 * 86400.0}))
    result.longest = core::Seconds{*longest};
  if (const auto every = reader.number("record_every_s", {1.0, 86400.0}))
    result.flight.record_every = core::Seconds{*every};
  read_other_data(reader, result);
  result.name = reader.text("name").value_or("");
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return result;
}

json to_json(const SimulateInputs& inputs) {
  json files = json::array();
  for (const SimulatedFile& file : inputs.mission_files)
    files.push_back({{"name", file.name}, {"text", file.text}});
  json result{{"plan_id", inputs.plan_id},
              {"mission_files", files.empty() ? json() : std::move(files)},
              {"vehicle", inputs.vehicle ? json(*inputs.vehicle) : json()},
              {"runs", inputs.runs},
              {"seed", inputs.seed},
              {"tracks", inputs.tracks},
              {"avoidance", inputs.avoidance},
              {"current_error", current_error_json(inputs.current_error)},
              {"sonar", sonar_json(inputs.sonar)},
              {"altimeter", altimeter_json(inputs.altimeter)},
              {"adcp", adcp_json(inputs.adcp)},
              {"navigation", navigation_json(inputs.flight.navigation)},
              {"longest_s", inputs.longest ? json(inputs.longest->count()) : json()},
              {"record_every_s", inputs.flight.record_every.count()},
              {"name", inputs.name}};
  result.update(inputs.data);
  return result;
}

}  // namespace floeplan::codec
