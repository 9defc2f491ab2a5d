#include <algorithm>
#include <stdexcept>

#include "api/codec/documents/job_document.hpp"
#include "api/routes/access/quotas.hpp"
#include "api/routes/processes/execution_request.hpp"
#include "api/routes/processes/job_reply.hpp"
#include "api/routes/processes/process_checks.hpp"
#include "api/routes/request/idempotency.hpp"
#include "api/routes/request/owner.hpp"
#include "api/routes/request/preferences.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/work/kept_answers.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

constexpr int longest_synchronous_wait_s = 600;

core::Violations under_inputs(core::Violations violations) {
  for (auto& violation : violations) violation.field.insert(0, "/inputs");
  return violations;
}

Response created(const Context& context, const repository::JobRecord& job, bool asked_for) {
  Response response = json_reply(codec::job_document(job, context.service.public_url), 201);
  response.headers.emplace_back("Location", context.service.public_url + "/jobs/" + job.id.value);
  if (!codec::is_finished(job.status)) response.headers.emplace_back("Retry-After", "1");
  if (asked_for) response.headers.emplace_back("Preference-Applied", "respond-async");
  return response;
}

/// Continues a synchronous execution: answers with the results if the job has ended, with the job if the time
/// is up.
Response resume(const Context& context, const Request& request) {
  const repository::JobId id{request.resumption->token};
  const auto job = repository::JobRepository{context.db}.find(id);
  if (!job) return problem_reply<"unknown-job">(request);
  if (codec::is_finished(job->status)) {
    Response response = results_reply(request, *job);
    if (response.status == 200) response.headers.emplace_back("Preference-Applied", "respond-sync");
    return response;
  }
  if (request.resumption->last) return created(context, *job, false);
  return waiting_for(context, id, id.value, core::Seconds{longest_synchronous_wait_s});
}

Response refused(const Request& request, SubmissionRefused reason) {
  switch (reason) {
    case SubmissionRefused::queue_full: {
      Response response = problem_reply<"queue-full">(request);
      response.headers.emplace_back("Retry-After", "30");
      return response;
    }
    case SubmissionRefused::key_reused: return key_reused(request);
    case SubmissionRefused::job_removed: return problem_reply<"job-removed">(request);
  }
  throw std::logic_error{"SubmissionRefused without a reply"};
}

/// The refusal of work whose result would exceed the caller's quota. A request that repeats an accepted key
/// is not refused.
std::optional<Response> over_quota(const Context& context, const Request& request,
                                   const Submission& submission) {
  if (submission.key && repository::KeptAnswers{context.db}.find(*submission.key)) return std::nullopt;
  if (submission.process == "ingest")
    return refuse_ingest(context, request, json::parse(submission.inputs_json).at("uploads"));
  if (submission.process == "plan-route" || submission.process == "simulate-plan")
    return refuse_document(context, request);
  return std::nullopt;
}

/// The job to submit, or the problem for the answer.
tl::expected<Submission, Response> submission_of(const Context& context, const Request& request,
                                                 const ProcessEntry& process) {
  const auto read = read_execution(request, process);
  if (!read) return tl::unexpected(read.error());
  auto key = idempotency_key(request);
  if (!key) return tl::unexpected(key.error());
  const auto inputs = checked_inputs(context, request, process.id, read->inputs);
  if (!inputs) return tl::unexpected(invalid(request, under_inputs(inputs.error())));

  Submission submission{.process = process.id,
                        .inputs_json = inputs->dump(),
                        .owner = owner_of(request),
                        .digest = {},
                        .force = read->force,
                        .reply_json = read->reply_json,
                        .key = std::move(*key)};
  const auto if_room = [&]() -> tl::expected<Submission, Response> {
    if (auto refusal = over_quota(context, request, submission)) return tl::unexpected(std::move(*refusal));
    return submission;
  };
  if (!process.shares_results) return if_room();
  submission.digest =
      result_digest(context, process.id + "\n" + submission.reply_json, submission.inputs_json);
  const auto shared = repository::JobRepository{context.db}.find_shared(*submission.digest, submission.owner);
  submission.force = submission.force || (shared && !result_stands(context, *shared));
  if (shared && !submission.force) return submission;
  return if_room();
}

/// Executes a process. Without a Prefer header the answer is the result, as the standard requires if both
/// modes exist.
Response execute(const Context& context, const Request& request, const PathParameters& path) {
  if (request.resumption) return resume(context, request);

  const ProcessEntry* process = find_process(path.at("process_id"));
  if (process == nullptr) return no_such_process(request, path.at("process_id"));
  const auto submission = submission_of(context, request, *process);
  if (!submission) return submission.error();
  const auto job = context.jobs.submit(context.db, *submission, request.now);
  if (!job) return refused(request, job.error());

  const Preferences wishes = parse_prefer(request.header("prefer"));
  if (wishes.respond_async && !wishes.respond_sync && !wishes.wait_s) return created(context, *job, true);
  const int wait_s = std::min(wishes.wait_s.value_or(longest_synchronous_wait_s), longest_synchronous_wait_s);
  return waiting_for(context, job->id, job->id.value, core::Seconds{static_cast<double>(wait_s)});
}

}  // namespace

std::vector<Route> execution_routes() {
  return {{.method = "POST",
           .pattern = "/processes/{process_id}/execution",
           .parameters = {},
           .answer = execute,
           .keeps_own_keys = true}};
}

}  // namespace floeplan::routes
