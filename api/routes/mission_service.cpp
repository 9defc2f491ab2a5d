#include "api/routes/mission_service.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "api/codec/plan_document.hpp"
#include "api/codec/plan_inputs.hpp"
#include "engine/mission/line_words.hpp"
#include "engine/mission/read_document.hpp"
#include "engine/mission/route_check.hpp"
#include "storage/repository/environment_loader.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr std::size_t longest_glider_name = 40;

/// The inputs that the plan was made with; nothing when an older version stored them in another form.
std::optional<codec::PlanInputs> inputs_of(const repository::PlanRecord& record) {
  auto inputs = codec::parse_plan_inputs(json::parse(record.request_json));
  return inputs ? std::optional{std::move(*inputs)} : std::nullopt;
}

/// No file leaves that our own reader would not take back without a word of warning.
void read_back(const mission::MissionFiles& files) {
  for (const auto& file : files.files) {
    const auto read = mission::read_document(file.name, file.text);
    if (read.verdict() != mission::Verdict::ok)
      throw std::logic_error{file.name + " was written wrongly: " + read.messages.front().text};
  }
}

mission::FileOrigin origin_of(const repository::PlanRecord& record, core::UtcTime generated) {
  return {record.id.value, record.name, generated, "floeplan " FLOEPLAN_VERSION};
}

tl::expected<mission::MissionFiles, core::Violations> seaglider_set_of(const repository::PlanRecord& record,
                                                                       const planning::Plan& plan,
                                                                       const MissionRequest& request,
                                                                       core::UtcTime generated) {
  mission::SeagliderOptions options;
  options.vehicle = vehicle_of(record, plan);
  options.bands = request.bands;
  options.origin = origin_of(record, generated);
  auto files = mission::write_seaglider_set(plan, options);
  if (files) read_back(*files);
  return files;
}

bool same_data(const std::vector<ocean::DatasetRef>& a, const std::vector<ocean::DatasetRef>& b) {
  return std::ranges::equal(a, b, [](const ocean::DatasetRef& x, const ocean::DatasetRef& y) {
    return x.id == y.id && x.sha256 == y.sha256;
  });
}

}  // namespace

vehicle::GliderProfile vehicle_of(const repository::PlanRecord& record, const planning::Plan& plan) {
  if (const auto inputs = inputs_of(record)) return inputs->request.vehicle;
  return vehicle::find_profile(plan.vehicle).value_or(vehicle::known_profiles().front());
}

tl::expected<mission::MissionFiles, core::Violations> mission_of(const repository::PlanRecord& record,
                                                                 const MissionRequest& request,
                                                                 core::UtcTime generated) {
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  if (request.seaglider) return seaglider_set_of(record, plan, request, generated);
  mission::MissionSetOptions options;
  options.vehicle = vehicle_of(record, plan);
  options.name = request.name;
  options.firmware = request.firmware;
  options.under_ice = request.under_ice;
  options.lists.first_number = request.number;
  options.lists.max_waypoints = options.vehicle.max_waypoints_per_list;
  options.lists.origin = origin_of(record, generated);

  const bool full = request.full || request.under_ice.has_value();
  auto files =
      full ? mission::write_mission_set(plan, options) : mission::write_goto_lists(plan, options.lists);
  if (files) read_back(*files);
  return files;
}

tl::expected<std::string, core::Violation> handover_folder(const std::string& glider, bool seaglider) {
  if (glider.empty()) return "";
  if (!mission::is_name(glider) || glider.size() > longest_glider_name)
    return tl::unexpected(core::Violation{
        "/glider", "must be one to 40 letters, digits and underscores, the name of a folder"});
  return seaglider ? glider + "/" : "gliders/" + glider + "/to-glider/";
}

std::optional<mission::Firmware> parse_firmware(const std::string& text) {
  mission::Firmware firmware;
  const char* const end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, firmware.major);
  if (major.ec != std::errc{} || major.ptr == end || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, firmware.minor);
  if (minor.ec != std::errc{} || minor.ptr != end || firmware.major < 0 || firmware.minor < 0)
    return std::nullopt;
  return firmware;
}

PlanCheck check_plan(sqlite::Connection& db, const repository::PlanRecord& record) {
  const planning::Plan plan = codec::parse_plan_document(json::parse(record.document_json));
  auto inputs = inputs_of(record);
  if (!inputs)
    return {{}, {"The plan was stored by another version and could not be checked in newer data."}};
  const auto environment = repository::load_environment(db, inputs->data);
  if (!environment) {
    return {{},
            {"The plan could not be checked in the stored data: " + environment.error().front().rule + "."}};
  }
  if (same_data(plan.datasets, environment->datasets)) return {};

  inputs->request.depart = plan.departure;  // of a window of departures, the best
  PlanCheck check;
  const auto found =
      mission::check_route(*environment, codec::route_of(json::parse(record.document_json)), inputs->request);
  for (const auto& finding : found.findings) {
    const std::string text =
        "In the newest data, leg " + std::to_string(finding.place) + ": " + finding.text + ".";
    (finding.dangerous ? check.dangers : check.warnings).push_back(text);
  }
  if (found.findings.empty()) {
    check.warnings.push_back(
        "The data have changed since the plan was made; in the newest ones it is still clear.");
  }
  return check;
}

}  // namespace floeplan::routes
