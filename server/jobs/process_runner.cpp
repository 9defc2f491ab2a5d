#include "server/jobs/process_runner.hpp"

#include "api/codec/documents/flight_comparison.hpp"
#include "api/codec/inputs/echo_inputs.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/inputs/reach_inputs.hpp"
#include "api/codec/inputs/scenario_inputs.hpp"
#include "api/codec/inputs/simulate_inputs.hpp"
#include "engine/core/violation_list.hpp"
#include "server/jobs/comparison_service.hpp"
#include "server/jobs/echo_service.hpp"
#include "server/jobs/plan_service.hpp"
#include "server/jobs/reach_service.hpp"
#include "server/jobs/scenario_service.hpp"
#include "server/jobs/simulation_service.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/access/owners.hpp"

namespace floeplan::jobs {
namespace {

using nlohmann::json;

std::string in_one_line(const core::Violations& violations) {
  std::string text;
  for (const auto& violation : core::shortened(violations)) {
    text += (text.empty() ? "" : "; ") + violation.field + " " + violation.rule;
  }
  return text;
}

/// A list of jobs must not call it done where the answer is that there is no route.
std::string why_no_route(const json& document) {
  const bool infeasible = document.contains("explanation") && document.value("status", "") == "infeasible";
  return infeasible ? "no route: " + document.at("explanation").get<std::string>() : "";
}

tl::expected<ProcessResult, std::string> result(const char* output,
                                                const tl::expected<json, core::Violations>& document) {
  if (!document) return tl::unexpected(in_one_line(document.error()));
  return ProcessResult{json{{output, *document}}.dump(), why_no_route(*document)};
}

/// Counts what the job stored for its owner; documents without an id say that nothing was.
void note_owner(sql::Connection& db, const repository::JobRecord& job, core::UtcTime now,
                const repository::ThingTable& table, const char* id,
                const tl::expected<json, core::Violations>& document) {
  if (document && document->contains(id))
    repository::Owners{db}.note_made(table, document->at(id).get<std::string>(), now, job.owner);
}

tl::expected<json, core::Violations> compare_flight_document(const codec::CompareFlightInputs& inputs,
                                                             const std::stop_token& stop,
                                                             const core::ProgressCallback& progress) {
  const ComparedFlights compared = compare_flights(inputs.logs, inputs.vehicle, inputs.drag, stop, progress);
  if (stop.stop_requested()) return json{{"status", "cancelled"}};
  if (!compared.violations.empty()) return tl::unexpected(compared.violations);
  return codec::comparison_document(compared.dives);
}

}  // namespace

tl::expected<ProcessResult, std::string> run_process(sql::Connection& db, const repository::JobRecord& job,
                                                     const IngestPlace& place, std::size_t workers,
                                                     KeptWork& kept, const std::stop_token& stop,
                                                     const core::ProgressCallback& progress,
                                                     core::UtcTime now) {
  const json request = json::parse(job.request_json);
  if (job.process == "plan-route") {
    const auto inputs = codec::parse_plan_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    const auto plan = plan_route_document(db, *inputs, stop, progress, now, &kept);
    note_owner(db, job, now, repository::plan_table, "plan_id", plan);
    return result("plan", plan);
  }
  if (job.process == "evaluate-route") {
    const auto inputs = codec::parse_evaluate_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    return result("evaluation", evaluate_route_document(db, *inputs, stop, &kept));
  }
  if (job.process == "reach") {
    const auto inputs = codec::parse_reach_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    return result("reach", reach_document(db, *inputs, stop, progress, &kept));
  }
  if (job.process == "ingest") {
    const auto inputs = codec::parse_ingest_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    const auto report = ingest_document(db, *inputs, place, job.owner, job.attempts > 1, stop, progress, now);
    if (!report) return tl::unexpected(report.error());
    return ProcessResult{json{{"report", *report}}.dump(-1, ' ', false, json::error_handler_t::replace)};
  }
  if (job.process == "simulate-plan") {
    const auto inputs = codec::parse_simulate_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    const auto simulation = simulate_plan_document(db, *inputs, workers, stop, progress, now);
    note_owner(db, job, now, repository::simulation_table, "simulation_id", simulation);
    return result("simulation", simulation);
  }
  if (job.process == "fly-scenario") {
    const auto inputs = codec::parse_scenario_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    return result("scenario", fly_scenario_document(*inputs, workers, stop, progress));
  }
  if (job.process == "compare-flight") {
    const auto inputs = codec::parse_compare_flight_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    return result("comparison", compare_flight_document(*inputs, stop, progress));
  }
  if (job.process == "echo") {
    const auto inputs = codec::parse_echo_inputs(request);
    if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
    return ProcessResult{echo_results(*inputs, stop, progress).dump()};
  }
  return tl::unexpected("this version knows no process " + job.process);
}

}  // namespace floeplan::jobs
