#include "api/service/mission_service.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "api/codec/bytes/text_values.hpp"
#include "api/codec/documents/plan_document.hpp"
#include "api/service/export_sea.hpp"
#include "engine/core/version.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/checking/yo_flight.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "engine/mission/writing/ice_files.hpp"
#include "engine/mission/writing/safe_places.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::service {
namespace {

using nlohmann::json;

constexpr std::size_t longest_glider_name = 40;

/// Verifies that this program's own reader accepts each file without a warning.
void read_back(const mission::MissionFiles& files) {
  for (const auto& file : files.files) {
    const auto read = mission::read_document(file.name, file.text);
    if (read.verdict() != mission::Verdict::ok)
      throw std::logic_error{file.name + " was written wrongly: " + read.messages.front().text};
  }
}

mission::FileOrigin origin_of(const repository::PlanRecord& record, core::UtcTime generated) {
  return {record.id.value, record.name, generated, std::string{core::program_version()}};
}

tl::expected<mission::MissionFiles, core::Violations> seaglider_set_of(sql::Connection& db,
                                                                       const repository::PlanRecord& record,
                                                                       const planning::Plan& plan,
                                                                       const MissionRequest& request,
                                                                       core::UtcTime generated) {
  mission::SeagliderOptions options;
  options.vehicle = vehicle_of(record, plan);
  options.bands = request.bands;
  options.origin = origin_of(record, generated);
  options.shoals = shoals_of(db, record, plan);
  return mission::write_seaglider_set(plan, options);
}

planning::UnderIceRules ice_rules_of(const repository::PlanRecord& record) {
  const auto inputs = inputs_of(record);
  return inputs ? inputs->request.under_ice : planning::UnderIceRules{};
}

mission::MissionSetOptions set_options(sql::Connection& db, const repository::PlanRecord& record,
                                       const planning::Plan& plan, const MissionRequest& request,
                                       core::UtcTime generated) {
  mission::MissionSetOptions options;
  options.vehicle = vehicle_of(record, plan);
  options.name = request.name;
  options.firmware = request.firmware;
  options.under_ice = request.under_ice;
  if (options.under_ice) options.under_ice->margin_below_ice = ice_rules_of(record).margin_below_ice;
  if (const auto inputs = inputs_of(record))
    options.surfacing_interval = inputs->request.under_ice.surfacing_interval;
  options.lists.first_number = request.number;
  options.lists.max_waypoints = options.vehicle.max_waypoints_per_list;
  options.lists.origin = origin_of(record, generated);
  options.lists.holds = holds_of(db, record, plan);
  options.shoals = shoals_of(db, record, plan);
  return options;
}

/// Checks the safe places in the newest data; empty if the writer of the files refuses them anyway.
mission::SafePlaceFindings judge_safe_places(sql::Connection& db, const repository::PlanRecord& record,
                                             const planning::Plan& plan,
                                             const mission::MissionSetOptions& options) {
  if (!options.under_ice || !mission::ice_violations(plan, options).empty()) return {};
  return mission::check_safe_places(plan, options.vehicle, ice_rules_of(record).max_concentration_to_surface,
                                    safe_places_of(db, record, plan, options.under_ice->safe_places));
}

/// The plan as the mission's yo flies it, in the newest data; empty if the yo flies it as planned.
mission::YoFlight judge_yo(sql::Connection& db, const repository::PlanRecord& record,
                           const planning::Plan& plan) {
  if (!mission::flies_otherwise(plan, vehicle_of(record, plan))) return {};
  const auto inputs = inputs_of(record);
  const auto sea =
      inputs ? repository::load_environment(db, inputs->data) : tl::unexpected(core::Violations{});
  if (!sea) {
    return {.violations = {}, .messages = {messages::export_message<"yo-not-checked">()}};
  }
  return mission::fly_by_yo(*sea, codec::route_of(json::parse(record.document_json)), inputs->request, plan);
}

/// Writes only the goto lists. The plan's messages describe the yo with which the pilot flies them.
tl::expected<mission::MissionFiles, core::Violations> lists_of(const planning::Plan& plan,
                                                               const mission::MissionSetOptions& options,
                                                               const mission::YoFlight& flight) {
  mission::GotoListOptions of_lists = mission::list_options(plan, options);
  // The mission on board may surface more rarely than one that this program writes, unless the plan has a
  // surfacing interval.
  if (!options.surfacing_interval) of_lists.between_fixes.reset();
  auto lists = mission::write_goto_lists(plan, of_lists);
  if (!lists) return lists;
  for (const core::Violation& violation : flight.violations)
    lists->messages.push_back(messages::export_message<"yo-cannot-fly-plan">(violation.rule));
  std::ranges::copy(flight.messages, std::back_inserter(lists->messages));
  return lists;
}

tl::expected<mission::MissionFiles, core::Violations> mission_set_of(
    sql::Connection& db, const repository::PlanRecord& record, const planning::Plan& plan,
    const mission::MissionSetOptions& options, mission::YoFlight flight) {
  auto set = mission::write_mission_set(plan, options);
  mission::SafePlaceFindings safe = judge_safe_places(db, record, plan, options);
  core::Violations found = std::move(safe.violations);
  std::ranges::move(flight.violations, std::back_inserter(found));
  if (!found.empty()) {
    if (!set) std::ranges::move(set.error(), std::back_inserter(found));
    return tl::unexpected(std::move(found));
  }
  if (!set) return set;
  std::ranges::move(safe.messages, std::back_inserter(set->messages));
  std::ranges::move(flight.messages, std::back_inserter(set->messages));
  return set;
}

}  // namespace

tl::expected<mission::MissionFiles, core::Violations> mission_of(sql::Connection& db,
                                                                 const repository::PlanRecord& record,
                                                                 const MissionRequest& request,
                                                                 core::UtcTime generated) {
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  const auto written = [&]() -> tl::expected<mission::MissionFiles, core::Violations> {
    if (request.seaglider) return seaglider_set_of(db, record, plan, request, generated);
    const mission::MissionSetOptions options = set_options(db, record, plan, request, generated);
    mission::YoFlight flight = judge_yo(db, record, plan);
    const bool full = request.full || request.under_ice.has_value();
    if (!full) return lists_of(plan, options, flight);
    return mission_set_of(db, record, plan, options, std::move(flight));
  }();
  if (written) read_back(*written);
  return written;
}

tl::expected<std::string, core::Violation> handover_folder(const std::string& glider, bool seaglider) {
  if (glider.empty()) return "";
  if (!mission::is_name(glider) || glider.size() > longest_glider_name)
    return tl::unexpected(messages::mission_fault<"wrong-glider-name">("/glider"));
  return seaglider ? glider + "/" : "gliders/" + glider + "/to-glider/";
}

std::optional<mission::Firmware> parse_firmware(const std::string& text) {
  constexpr std::int64_t most = 999;
  const auto parts = codec::split(text, '.');
  if (parts.size() != 2) return std::nullopt;
  const auto major = codec::parse_integer(parts[0]);
  const auto minor = codec::parse_integer(parts[1]);
  const auto valid = [](const std::optional<std::int64_t>& number) {
    return number && *number >= 0 && *number <= most;
  };
  if (!valid(major) || !valid(minor)) return std::nullopt;
  return mission::Firmware{static_cast<int>(*major), static_cast<int>(*minor)};
}

}  // namespace floeplan::service
