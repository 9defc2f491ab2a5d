#include "api/codec/bytes/document_values.hpp"
#include "api/codec/bytes/zip_archive.hpp"
#include "api/routes/plans/plan_exports.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/service/mission_service.hpp"
#include "api/service/plan_check.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/mission/document/comment_text.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::PlanRecord;

constexpr std::size_t longest_header = 300;

Response download(const std::string& file_name, const std::string& type, std::string bytes) {
  Response response;
  response.content_type = type;
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + file_name + "\"");
  response.body = std::move(bytes);
  return response;
}

void add_warnings(Response& response, const std::vector<messages::Message>& told) {
  for (const std::string& warning : messages::sentences(told))
    response.headers.emplace_back("Floeplan-Warning", mission::comment_text(warning, longest_header));
}

Response refuse_dangerous(const Request& request, const std::vector<messages::Message>& dangers) {
  core::Violations found;
  for (const messages::Message& danger : dangers) found.push_back({"/plan", messages::whole_text(danger)});
  return problem_reply(request, problems::problem<"dangerous-plan">().with(std::move(found)));
}

/// Whether the pilot has to confirm the dangers of a plan before the answer.
enum class Dangers { to_confirm, told_in_answer };

/// Calls `answer` with the stored plan that the path names and with the result of its check in newer data. A
/// plan with dangers is refused, unless the request accepts them or the answer shows them itself.
template <class Answer>
Response with_plan(const Context& context, const Request& request, const PathParameters& path, Dangers rule,
                   const Answer& answer) {
  const auto plan = repository::PlanRepository{context.db}.find({path.at("plan_id")});
  if (!plan) return problem_reply<"unknown-plan">(request, path.at("plan_id"));
  ParameterReader reader{request};
  const bool accept_dangers = reader.flag("accept_dangers");
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const service::PlanCheck check = service::check_plan(context.db, *plan);
  const std::vector<messages::Message> dangers = check.to_confirm();
  if (rule == Dangers::to_confirm && !dangers.empty() && !accept_dangers)
    return refuse_dangerous(request, dangers);
  const std::vector<messages::Message> told = service::all_of(check);
  Response response = answer(*plan, told);
  add_warnings(response, told);
  return response;
}

/// Reads safe places in open water, "lon,lat;lon,lat", and the depth of icebergs.
std::optional<mission::UnderIce> read_under_ice(ParameterReader& reader) {
  const auto draft = reader.number("iceberg_depth_m", 1.0, 1000.0);
  const auto safe = reader.places("safe");
  if (!safe) {
    if (draft) reader.require("safe", "places in open water, since iceberg_depth_m asks for work under ice");
    return std::nullopt;
  }
  mission::UnderIce ice;
  ice.safe_places = *safe;
  if (draft) ice.deepest_expected_iceberg = core::Metres{*draft};
  return ice;
}

/// Reads `format`, and the depth bands of a Seaglider's science file, as "20:5:1110:60;200:10:1100:120".
void read_seaglider(const Request& request, service::MissionRequest& wanted, core::Violations& faults) {
  const std::string format = request.parameter("format").value_or("gliderdos");
  wanted.seaglider = format == "seaglider";
  if (!wanted.seaglider && format != "gliderdos")
    faults.push_back({"?format", "must be gliderdos or seaglider"});
  std::string text = request.parameter("science").value_or("");
  if (!text.empty() && !wanted.seaglider) faults.push_back({"?science", "is for format=seaglider"});
  while (!text.empty()) {
    const std::string one = text.substr(0, text.find(';'));
    text.erase(0, one.size() + 1);
    if (const auto band = mission::parse_science_band(one)) {
      wanted.bands.push_back(*band);
    } else {
      core::note(faults,
                 {"?science", "must be bands DEPTH:SECONDS:SENSORS:GC between semicolons, not " + one});
    }
  }
}

/// Writes the mission files and passes them to `answer`; if request or plan have faults, the answer lists
/// them.
template <class Answer>
Response with_files(const Context& context, const Request& request, const PlanRecord& record,
                    const Answer& answer) {
  ParameterReader reader{request};
  service::MissionRequest wanted;
  wanted.number = static_cast<int>(reader.integer("number", 0, 97).value_or(wanted.number));
  wanted.full = reader.flag("full");
  wanted.name = request.parameter("mission").value_or(wanted.name);
  wanted.under_ice = read_under_ice(reader);
  core::Violations faults = reader.violations();
  read_seaglider(request, wanted, faults);
  if (const auto text = request.parameter("firmware")) {
    const auto firmware = service::parse_firmware(*text);
    if (!firmware) faults.push_back({"?firmware", "must be a version, as 10.5"});
    wanted.firmware = firmware.value_or(wanted.firmware);
  }
  if (!faults.empty()) return invalid(request, faults);

  auto files = service::mission_of(context.db, record, wanted, request.now);
  if (!files) return invalid(request, files.error());
  return answer(*files);
}

Response show_mission(const Context& context, const Request& request, const PathParameters& path) {
  return with_plan(context, request, path, Dangers::to_confirm,
                   [&](const PlanRecord& plan, const std::vector<messages::Message>& told) {
                     return with_files(context, request, plan, [&](const mission::MissionFiles& set) {
                       json files = json::array();
                       for (const auto& file : set.files)
                         files.push_back({{"name", file.name}, {"text", file.text}});
                       std::vector<messages::Message> all = told;
                       all.insert(all.end(), set.messages.begin(), set.messages.end());
                       json document{{"files", std::move(files)}};
                       codec::tell(document, std::move(all));
                       return json_reply(document);
                     });
                   });
}

Response download_zip(const Context& context, const Request& request, const PathParameters& path) {
  const bool seaglider = request.parameter("format") == "seaglider";
  const auto folder = service::handover_folder(request.parameter("glider").value_or(""), seaglider);
  if (!folder) return invalid(request, {{"?glider", folder.error().rule}});
  return with_plan(context, request, path, Dangers::to_confirm,
                   [&](const PlanRecord& plan, const std::vector<messages::Message>&) {
                     return with_files(context, request, plan, [&](const mission::MissionFiles& set) {
                       std::vector<codec::ArchivedFile> files;
                       files.reserve(set.files.size());
                       for (const auto& file : set.files) files.push_back({*folder + file.name, file.text});
                       Response response = download(download_stem(plan) + ".zip", "application/zip",
                                                    codec::zip_archive(files, request.now));
                       add_warnings(response, set.messages);
                       return response;
                     });
                   });
}

/// The handler that answers with the plan in a format of a single file.
auto download_as(const ExportFormat& format) {
  return [&format](const Context& context, const Request& request, const PathParameters& path) {
    ParameterReader reader{request};
    const auto safe_places = format.is_brief ? reader.places("safe") : std::nullopt;
    if (!reader.violations().empty()) return invalid(request, reader.violations());
    return with_plan(context, request, path, format.is_brief ? Dangers::told_in_answer : Dangers::to_confirm,
                     [&](const PlanRecord& plan, const std::vector<messages::Message>& told) {
                       auto exported =
                           export_plan(context.db, plan, format, told,
                                       safe_places.value_or(std::vector<geo::LonLat>{}), request.now);
                       if (!exported) return invalid(request, exported.error());
                       Response response = download(export_file_name(format, download_stem(plan)),
                                                    format.content_type, std::move(exported->bytes));
                       add_warnings(response, exported->messages);
                       return response;
                     });
  };
}

}  // namespace

std::vector<Route> mission_routes() {
  const std::string plan = "/collections/plans/items/{plan_id}";
  const std::vector<std::string> of_files{"number",          "full",           "mission", "firmware", "safe",
                                          "iceberg_depth_m", "accept_dangers", "format",  "science"};
  std::vector<std::string> of_zip = of_files;
  of_zip.emplace_back("glider");
  std::vector<Route> routes{{"GET", plan + "/mission", of_files, show_mission},
                            {"GET", plan + "/mission.zip", of_zip, download_zip}};
  for (const ExportFormat& format : export_formats()) {
    std::vector<std::string> parameters{"accept_dangers"};
    if (format.is_brief) parameters.emplace_back("safe");
    routes.push_back({"GET", plan + "/mission." + format.name, std::move(parameters), download_as(format)});
  }
  return routes;
}

}  // namespace floeplan::routes
