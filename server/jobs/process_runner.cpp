#include "server/jobs/process_runner.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "api/codec/documents/flight_comparison.hpp"
#include "api/codec/inputs/echo_inputs.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/inputs/reach_inputs.hpp"
#include "api/codec/inputs/scenario_inputs.hpp"
#include "api/codec/inputs/simulate_inputs.hpp"
#include "api/service/comparison_service.hpp"
#include "api/service/echo_service.hpp"
#include "api/service/plan_service.hpp"
#include "api/service/reach_service.hpp"
#include "api/service/scenario_service.hpp"
#include "api/service/simulation_service.hpp"
#include "engine/core/violation_list.hpp"
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

/// The job's message if there is no route, so that a list of jobs does not show it simply as successful.
std::string why_no_route(const json& document) {
  const bool infeasible = document.contains("explanation") && document.value("status", "") == "infeasible";
  return infeasible ? "no route: " + document.at("explanation").get<std::string>() : "";
}

tl::expected<ProcessResult, std::string> result(const char* output,
                                                const tl::expected<json, core::Violations>& document) {
  if (!document) return tl::unexpected(in_one_line(document.error()));
  return ProcessResult{json{{output, *document}}.dump(), why_no_route(*document)};
}

/// Records the owner of the stored result; a document without an id means that nothing was stored.
void note_owner(sql::Connection& db, const repository::JobRecord& job, core::UtcTime now,
                const repository::ThingTable& table, const char* id,
                const tl::expected<json, core::Violations>& document) {
  if (document && document->contains(id))
    repository::Owners{db}.note_made(table, document->at(id).get<std::string>(), now, job.owner);
}

/// A running job, with the connection, caches and threads that its process may use.
struct Work {
  sql::Connection& db;
  const repository::JobRecord& job;
  const service::IngestPlace& place;
  const core::Executor& executor;
  service::KeptWork& kept;
  const std::stop_token& stop;
  const core::ProgressCallback& progress;
  core::UtcTime now;
};

using Outcome = tl::expected<ProcessResult, std::string>;

Outcome plan_route(const Work& work, const codec::PlanInputs& inputs) {
  const auto plan = service::plan_route_document(work.db, inputs, work.executor, work.stop, work.progress,
                                                 work.now, &work.kept);
  note_owner(work.db, work.job, work.now, repository::plan_table, "plan_id", plan);
  return result("plan", plan);
}

Outcome evaluate_route(const Work& work, const codec::EvaluateInputs& inputs) {
  return result("evaluation", service::evaluate_route_document(work.db, inputs, work.stop, &work.kept));
}

Outcome find_reach(const Work& work, const codec::ReachInputs& inputs) {
  return result("reach", service::reach_document(work.db, inputs, work.stop, work.progress, &work.kept));
}

Outcome ingest_files(const Work& work, const codec::IngestInputs& inputs) {
  const auto report = service::ingest_document(work.db, inputs, work.place, work.job.owner,
                                               work.job.attempts > 1, work.stop, work.progress, work.now);
  if (!report) return tl::unexpected(report.error());
  return ProcessResult{json{{"report", *report}}.dump(-1, ' ', false, json::error_handler_t::replace)};
}

Outcome simulate_plan(const Work& work, const codec::SimulateInputs& inputs) {
  const auto simulation =
      service::simulate_plan_document(work.db, inputs, work.executor, work.stop, work.progress, work.now);
  note_owner(work.db, work.job, work.now, repository::simulation_table, "simulation_id", simulation);
  return result("simulation", simulation);
}

Outcome fly_scenario(const Work& work, const codec::ScenarioInputs& inputs) {
  return result("scenario", service::fly_scenario_document(inputs, work.executor, work.stop, work.progress));
}

Outcome compare_flight(const Work& work, const codec::CompareFlightInputs& inputs) {
  const service::ComparedFlights compared =
      service::compare_flights(inputs.logs, inputs.vehicle, inputs.drag, work.stop, work.progress);
  if (work.stop.stop_requested()) return result("comparison", json{{"status", "cancelled"}});
  if (!compared.violations.empty()) return tl::unexpected(in_one_line(compared.violations));
  return result("comparison", codec::comparison_document(compared.dives));
}

Outcome echo(const Work& work, const codec::EchoInputs& inputs) {
  return ProcessResult{service::echo_results(inputs, work.stop, work.progress).dump()};
}

/// Parses the inputs, which another version may have stored, and does the work.
template <auto parse, auto run>
Outcome with_inputs(const Work& work) {
  const auto inputs = parse(json::parse(work.job.request_json));
  if (!inputs) return tl::unexpected(in_one_line(inputs.error()));
  return run(work, *inputs);
}

struct Process {
  std::string_view id;
  Outcome (*run)(const Work&);
};

/// All processes of jobs; `api/routes/processes` describes them and checks their inputs.
constexpr auto processes = std::to_array<Process>({
    {"plan-route", with_inputs<codec::parse_plan_inputs, plan_route>},
    {"evaluate-route", with_inputs<codec::parse_evaluate_inputs, evaluate_route>},
    {"reach", with_inputs<codec::parse_reach_inputs, find_reach>},
    {"ingest", with_inputs<codec::parse_ingest_inputs, ingest_files>},
    {"simulate-plan", with_inputs<codec::parse_simulate_inputs, simulate_plan>},
    {"fly-scenario", with_inputs<codec::parse_scenario_inputs, fly_scenario>},
    {"compare-flight", with_inputs<codec::parse_compare_flight_inputs, compare_flight>},
    {"echo", with_inputs<codec::parse_echo_inputs, echo>},
});

}  // namespace

tl::expected<ProcessResult, std::string> run_process(sql::Connection& db, const repository::JobRecord& job,
                                                     const service::IngestPlace& place,
                                                     const core::Executor& executor, service::KeptWork& kept,
                                                     const std::stop_token& stop,
                                                     const core::ProgressCallback& progress,
                                                     core::UtcTime now) {
  const auto process = std::ranges::find(processes, job.process, &Process::id);
  if (process == processes.end()) return tl::unexpected("this version knows no process " + job.process);
  return process->run({db, job, place, executor, kept, stop, progress, now});
}

}  // namespace floeplan::jobs
