#include <nlohmann/json.hpp>

#include "api/codec/plan_document.hpp"
#include "api/codec/plan_geojson.hpp"
#include "api/codec/plan_gpx.hpp"
#include "api/codec/zip_archive.hpp"
#include "api/routes/mission_service.hpp"
#include "api/routes/parameters.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "storage/repository/plan_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::PlanRecord;

Response download(const PlanRecord& plan, const std::string& ending, const std::string& type,
                  std::string bytes) {
  Response response;
  response.content_type = type;
  response.headers.emplace_back("Content-Disposition",
                                "attachment; filename=\"" + plan.id.value + ending + "\"");
  response.body = std::move(bytes);
  return response;
}

/// Calls `answer` with the stored plan that the path names.
template <class Answer>
Response with_plan(const Context& context, const Request& request, const PathParameters& path,
                   const Answer& answer) {
  const auto plan = repository::PlanRepository{context.db}.find({path.at("plan_id")});
  if (!plan) return not_found(request, "unknown-plan", "No plan has the id " + path.at("plan_id") + ".");
  return answer(*plan);
}

/// Writes the goto lists and hands them to `answer`; every fault of request or plan is listed instead.
template <class Answer>
Response with_lists(const Request& request, const PlanRecord& record, const Answer& answer) {
  ParameterReader reader{request};
  const auto number = reader.integer("number", 0, 97);
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const auto lists = mission_of(record, static_cast<int>(number.value_or(10)), request.now);
  return lists ? answer(*lists) : invalid(request, lists.error());
}

Response show_mission(const Context& context, const Request& request, const PathParameters& path) {
  return with_plan(context, request, path, [&](const PlanRecord& plan) {
    return with_lists(request, plan, [](const mission::GotoLists& lists) {
      json files = json::array();
      for (const auto& file : lists.files) files.push_back({{"name", file.name}, {"text", file.text}});
      return json_reply({{"files", std::move(files)}, {"warnings", lists.warnings}});
    });
  });
}

Response download_zip(const Context& context, const Request& request, const PathParameters& path) {
  return with_plan(context, request, path, [&](const PlanRecord& plan) {
    return with_lists(request, plan, [&](const mission::GotoLists& lists) {
      std::vector<codec::ArchivedFile> files;
      for (const auto& file : lists.files) files.push_back({file.name, file.text});
      return download(plan, ".zip", "application/zip", codec::zip_archive(files, request.now));
    });
  });
}

Response download_gpx(const Context& context, const Request& request, const PathParameters& path) {
  return with_plan(context, request, path, [](const PlanRecord& plan) {
    const auto parsed = codec::parse_plan_document(json::parse(plan.document_json));
    return download(plan, ".gpx", "application/gpx+xml", codec::plan_gpx(parsed, plan.id.value, plan.name));
  });
}

Response download_geojson(const Context& context, const Request& request, const PathParameters& path) {
  return with_plan(context, request, path, [](const PlanRecord& plan) {
    return download(plan, ".geojson", "application/geo+json", codec::plan_geojson(plan).dump());
  });
}

}  // namespace

std::vector<Route> mission_routes() {
  const std::string plan = "/collections/plans/items/{plan_id}";
  return {{"GET", plan + "/mission", {"number"}, show_mission},
          {"GET", plan + "/mission.zip", {"number"}, download_zip},
          {"GET", plan + "/mission.gpx", {}, download_gpx},
          {"GET", plan + "/mission.geojson", {}, download_geojson}};
}

}  // namespace floeplan::routes
