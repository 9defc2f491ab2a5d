#include <algorithm>
#include <string_view>

#include "api/codec/documents/job_document.hpp"
#include "api/routes/processes/job_reply.hpp"
#include "api/routes/request/paging.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/preferences.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "api/routes/request/store_trouble.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;
using repository::JobRecord;

constexpr int longest_poll_s = 30;

/// A text that changes whenever the job changes visibly for a client.
std::string fingerprint(const JobRecord& job) {
  return repository::status_name(job.status) + "|" + job.stage + "|" + std::to_string(job.progress);
}

/// Reads the filter of a list of jobs: parameters of OGC API - Processes, Part 1, 7.15. `type` can only be
/// "process"; of a repeated parameter the last one counts.
repository::JobFilter read_filter(ParameterReader& reader, const Request& request) {
  repository::JobFilter filter;
  if (const auto name = reader.one_of("status", {"accepted", "running", "successful", "failed", "dismissed"}))
    filter.status = repository::parse_status(*name);
  static_cast<void>(reader.one_of("type", {"process"}));
  filter.process = request.parameter("processID");
  const TimeSpan created = reader.datetime();
  filter.created_from = created.from;
  filter.created_to = created.to;
  constexpr double a_year_s = 3.2e7;
  if (const auto least = reader.number("minDuration", 0.0, a_year_s))
    filter.least_duration = core::Seconds{*least};
  if (const auto most = reader.number("maxDuration", 0.0, a_year_s))
    filter.most_duration = core::Seconds{*most};
  return filter;
}

Response list_jobs(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const int limit = std::min(reader.limit(), 1000);
  const auto before = reader.integer("before", 0, INT64_MAX).value_or(0);
  const auto filter = read_filter(reader, request);
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const std::string& url = context.service.public_url;
  const auto [records, damaged] =
      repository::JobRepository{context.db}.list_past_damage(before, limit, filter);
  json jobs = json::array();
  for (const auto& job : records) jobs.push_back(codec::job_document(job, url));
  json links = json::array({link("self", "application/json", address_of(request, url))});
  if (records.size() == static_cast<std::size_t>(limit)) {
    links.push_back(link("next", "application/json",
                         address_with(request, url, "before", std::to_string(records.back().row))));
  }
  json page{{"jobs", std::move(jobs)}, {"links", std::move(links)}};
  name_damaged(page, damaged);
  return json_reply(page);
}

/// Answers with the job; with "Prefer: wait=N" at its next change, or after N seconds.
Response show_job(const Context& context, const Request& request, const PathParameters& path) {
  const auto job = repository::JobRepository{context.db}.find({path.at("job_id")});
  if (!job) return no_such_job(request, path.at("job_id"));

  const auto wait_s = parse_prefer(request.header("prefer")).wait_s;
  const std::string seen = request.resumption ? request.resumption->token : fingerprint(*job);
  const bool answer_now = !wait_s || codec::is_finished(job->status) || seen != fingerprint(*job) ||
                          (request.resumption && request.resumption->last);
  if (!answer_now) {
    return waiting_for(context, job->id, seen,
                       core::Seconds{static_cast<double>(std::min(*wait_s, longest_poll_s))});
  }
  Response response = json_reply(codec::job_document(*job, context.service.public_url));
  response.headers.emplace_back("Cache-Control", "no-cache");
  if (!codec::is_finished(job->status)) response.headers.emplace_back("Retry-After", "1");
  if (wait_s) response.headers.emplace_back("Preference-Applied", "wait=" + std::to_string(*wait_s));
  return response;
}

Response show_results(const Context& context, const Request& request, const PathParameters& path) {
  const auto job = repository::JobRepository{context.db}.find({path.at("job_id")});
  return job ? results_reply(request, *job) : no_such_job(request, path.at("job_id"));
}

/// Stops a job that has not ended; removes a job that has.
Response dismiss_job(const Context& context, const Request& request, const PathParameters& path) {
  repository::JobRepository jobs{context.db};
  const auto job = jobs.find({path.at("job_id")});
  if (!job) return no_such_job(request, path.at("job_id"));

  if (!context.jobs.dismiss(context.db, job->id, request.now)) jobs.remove(job->id);
  JobRecord dismissed = jobs.find(job->id).value_or(*job);
  dismissed.status = repository::JobStatus::dismissed;
  return json_reply(codec::job_document(dismissed, context.service.public_url));
}

}  // namespace

std::vector<Route> job_routes() {
  return {{"GET",
           "/jobs",
           {"limit", "before", "type", "processID", "status", "datetime", "minDuration", "maxDuration"},
           list_jobs},
          {"GET", "/jobs/{job_id}", {}, show_job},
          {"GET", "/jobs/{job_id}/results", {}, show_results},
          {"DELETE", "/jobs/{job_id}", {}, dismiss_job}};
}

}  // namespace floeplan::routes
