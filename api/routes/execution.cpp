#include <algorithm>
#include <set>

#include "api/codec/ingest_inputs.hpp"
#include "api/codec/job_document.hpp"
#include "api/codec/json_text.hpp"
#include "api/codec/plan_inputs.hpp"
#include "api/codec/reach_inputs.hpp"
#include "api/codec/simulate_inputs.hpp"
#include "api/routes/job_reply.hpp"
#include "api/routes/preferences.hpp"
#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/plan_repository.hpp"
#include "storage/repository/upload_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::DatasetKind;

constexpr int longest_synchronous_wait_s = 600;

core::Violations under_inputs(core::Violations violations) {
  for (auto& violation : violations) violation.field.insert(0, "/inputs");
  return violations;
}

/// Notes every named dataset that is not there or is of another kind, before a job exists.
void check_choice(sqlite::Connection& db, const repository::DatasetChoice& choice, const std::string& key,
                  DatasetKind kind, core::Violations& violations) {
  for (const auto& id : choice.ids) {
    const auto dataset = repository::DatasetRepository{db}.find(id);
    if (!dataset)
      violations.push_back({"/" + key, "no dataset has the id " + id.value + "; /datasets lists them"});
    if (dataset && dataset->kind != kind) {
      violations.push_back(
          {"/" + key, "the dataset " + id.value + " is of kind " + kind_name(dataset->kind)});
    }
  }
}

core::Violations check_data(sqlite::Connection& db, const repository::EnvironmentQuery& data) {
  core::Violations violations;
  check_choice(db, data.currents, "currents", DatasetKind::currents, violations);
  check_choice(db, data.tides.choice, "tides", DatasetKind::tides, violations);
  check_choice(db, data.wind, "wind", DatasetKind::wind, violations);
  check_choice(db, data.bathymetry, "bathymetry", DatasetKind::bathymetry, violations);
  check_choice(db, data.ice, "ice", DatasetKind::ice, violations);
  check_choice(db, data.icebergs, "icebergs", DatasetKind::icebergs, violations);
  check_choice(db, data.coastline, "coastline", DatasetKind::coastline, violations);
  check_choice(db, data.zones, "zones", DatasetKind::zones, violations);
  return violations;
}

/// The inputs in canonical form, ready for the queue.
tl::expected<json, core::Violations> checked_plan_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_plan_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_evaluate_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_evaluate_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (parsed->plan_id && !repository::PlanRepository{context.db}.find({*parsed->plan_id})) {
    violations.push_back({"/plan_id", "no plan has the id " + *parsed->plan_id});
  }
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_reach_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_reach_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  auto violations = check_data(context.db, parsed->data);
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_ingest_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_ingest_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  const repository::UploadRepository uploads{context.service.uploads};
  core::Violations violations;
  std::set<std::string> names;
  for (std::size_t i = 0; i < parsed->uploads.size(); ++i) {
    const std::string pointer = "/uploads/" + std::to_string(i);
    const auto upload = uploads.find(parsed->uploads[i]);
    if (!upload) {
      violations.push_back(
          {pointer, "no upload has the id " + parsed->uploads[i] + "; it was removed or has expired"});
    } else if (!names.insert(upload->name).second) {
      violations.push_back(
          {pointer, "a file named " + upload->name + " is there already; ingest them one by one"});
    }
  }
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return codec::to_json(*parsed);
}

tl::expected<json, core::Violations> checked_simulate_inputs(const Context& context, const json& inputs) {
  const auto parsed = codec::parse_simulate_inputs(inputs);
  if (!parsed) return tl::unexpected(parsed.error());
  if (!repository::PlanRepository{context.db}.find({parsed->plan_id}))
    return tl::unexpected(core::Violations{{"/plan_id", "no plan has the id " + parsed->plan_id}});
  return codec::to_json(*parsed);
}

using CheckInputs = tl::expected<json, core::Violations> (*)(const Context&, const json&);

/// Null when there is no such process.
CheckInputs check_of(const std::string& process) {
  if (process == "plan-route") return checked_plan_inputs;
  if (process == "evaluate-route") return checked_evaluate_inputs;
  if (process == "reach") return checked_reach_inputs;
  if (process == "ingest") return checked_ingest_inputs;
  if (process == "simulate-plan") return checked_simulate_inputs;
  return nullptr;
}

/// The `inputs` of an execute request.
tl::expected<json, core::Violations> inputs_of(const json& body) {
  if (!body.is_object()) return tl::unexpected(core::Violations{{"", "must be an object with \"inputs\""}});
  core::Violations violations;
  for (const auto& [key, value] : body.items()) {
    if (key != "inputs" && key != "outputs" && key != "response") {
      violations.push_back({"/" + key, "is not known; the known keys are inputs, outputs, response"});
    }
  }
  if (!body.contains("inputs")) violations.push_back({"/inputs", "is required"});
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  return body.at("inputs");
}

Response created(const Context& context, const repository::JobRecord& job, bool asked_for) {
  Response response = json_reply(codec::job_document(job, context.service.public_url), 201);
  response.headers.emplace_back("Location", context.service.public_url + "/jobs/" + job.id.value);
  response.headers.emplace_back("Retry-After", "1");
  if (asked_for) response.headers.emplace_back("Preference-Applied", "respond-async");
  return response;
}

/// Second part of a synchronous execution: the results when the job has ended, the job when the time is up.
Response resume(const Context& context, const Request& request) {
  const repository::JobId id{request.resumption->token};
  const auto job = repository::JobRepository{context.db}.find(id);
  if (!job) return not_found(request, "unknown-job", "The job was removed while its result was waited for.");
  if (codec::is_finished(job->status)) {
    Response response = results_reply(request, *job);
    if (response.status == 200) response.headers.emplace_back("Preference-Applied", "respond-sync");
    return response;
  }
  if (request.resumption->last) return created(context, *job, false);
  return waiting_for(context, id, id.value, core::Seconds{longest_synchronous_wait_s});
}

Response execute(const Context& context, const Request& request, const PathParameters& path) {
  if (request.resumption) return resume(context, request);

  const std::string& process = path.at("process_id");
  const CheckInputs check = check_of(process);
  if (check == nullptr) {
    return not_found(request, "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-process",
                     "No process has the id " + process + ".");
  }
  const std::string type = request.header("content-type");
  if (!type.empty() && type.find("json") == std::string::npos) {
    return problem_reply(
        request,
        {415, "unsupported-media-type", "Unsupported media type", "The body must be application/json.", {}});
  }
  const auto body = codec::parse_json(request.body);
  if (!body) return problem_reply(request, {400, "invalid-json", "Invalid JSON", body.error(), {}});
  const auto raw = inputs_of(*body);
  if (!raw) return invalid(request, raw.error());
  const auto inputs = check(context, *raw);
  if (!inputs) return invalid(request, under_inputs(inputs.error()));

  const auto job = context.jobs.submit(context.db, process, inputs->dump(), request.now);
  if (!job) {
    Response response = problem_reply(
        request, {503, "queue-full", "The queue is full", "Too many jobs are waiting; try again later.", {}});
    response.headers.emplace_back("Retry-After", "30");
    return response;
  }
  const Preferences wishes = parse_prefer(request.header("prefer"));
  if (!wishes.respond_sync) return created(context, *job, wishes.respond_async);
  const int wait_s = std::min(wishes.wait_s.value_or(longest_synchronous_wait_s), longest_synchronous_wait_s);
  return waiting_for(context, job->id, job->id.value, core::Seconds{static_cast<double>(wait_s)});
}

}  // namespace

std::vector<Route> execution_routes() { return {{"POST", "/processes/{process_id}/execution", {}, execute}}; }

}  // namespace floeplan::routes
