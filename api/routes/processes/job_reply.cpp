#include "api/routes/processes/job_reply.hpp"

#include <stdexcept>

#include "api/routes/request/reply.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

using nlohmann::json;
using repository::JobStatus;

namespace {

/// A single output: a text as plain text, any other value as JSON.
Response raw_value(const json& value) {
  if (!value.is_string()) return json_reply(value);
  Response response;
  response.content_type = "text/plain; charset=utf-8";
  response.body = value.get<std::string>();
  return response;
}

/// The requested outputs in the requested form: as a document, or a single output as its raw value.
Response wanted_results(const repository::JobRecord& job) {
  const json reply = json::parse(job.reply_json);
  const json wanted = reply.value("outputs", json::array());
  const bool raw = reply.value("response", "document") == "raw";
  if (wanted.empty() && !raw) {
    Response response;
    response.content_type = "application/json";
    response.body = job.result_json.value_or("{}");
    return response;
  }
  const json all = json::parse(job.result_json.value_or("{}"));
  json results = wanted.empty() ? all : json::object();
  for (const json& name : wanted) {
    const auto found = all.find(name.get<std::string>());
    if (found != all.end()) results[found.key()] = *found;
  }
  return raw && results.size() == 1 ? raw_value(*results.begin()) : json_reply(results);
}

}  // namespace

Response results_reply(const Request& request, const repository::JobRecord& job) {
  switch (job.status) {
    case JobStatus::successful: return wanted_results(job);
    case JobStatus::failed: return problem_reply<"job-failed">(request, job.message);
    case JobStatus::dismissed: return problem_reply<"job-dismissed">(request);
    case JobStatus::accepted:
    case JobStatus::running: return problem_reply<"result-not-ready">(request);
  }
  throw std::logic_error{"JobStatus without a reply"};
}

Response waiting_for(const Context& context, const repository::JobId& id, const std::string& token,
                     core::Seconds at_most) {
  Response response;
  JobGateway* jobs = &context.jobs;
  response.wait = Wait{at_most, token, [jobs, id](std::function<void()> wake) {
                         return jobs->subscribe(id, std::move(wake));
                       }};
  return response;
}

}  // namespace floeplan::routes
