#include "api/routes/job_reply.hpp"

#include <stdexcept>

#include "api/routes/reply.hpp"

namespace floeplan::routes {

using repository::JobStatus;

Response results_reply(const Request& request, const repository::JobRecord& job) {
  switch (job.status) {
    case JobStatus::successful: {
      Response response;
      response.content_type = "application/json";
      response.body = job.result_json.value_or("{}");
      return response;
    }
    case JobStatus::failed:
      return problem_reply(request, {400, "job-failed", "The job failed", job.message, {}});
    case JobStatus::dismissed:
      return problem_reply(
          request, {410, "job-dismissed", "The job was dismissed", "A dismissed job has no results.", {}});
    case JobStatus::accepted:
    case JobStatus::running:
      return problem_reply(request,
                           {404,
                            "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/result-not-ready",
                            "Results not ready",
                            "The job has not ended yet; ask for its status.",
                            {}});
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
