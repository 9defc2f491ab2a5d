#include "api/codec/documents/job_document.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using repository::JobStatus;

json links(const repository::JobRecord& job, const std::string& public_url) {
  const std::string self = public_url + "/jobs/" + job.id.value;
  json result = json::array({{{"rel", "self"}, {"type", "application/json"}, {"href", self}},
                             {{"rel", "monitor"}, {"type", "application/json"}, {"href", self}}});
  if (job.status == JobStatus::successful) {
    result.push_back({{"rel", "http://www.opengis.net/def/rel/ogc/1.0/results"},
                      {"type", "application/json"},
                      {"href", self + "/results"}});
  }
  return result;
}

}  // namespace

bool is_finished(JobStatus status) { return status != JobStatus::accepted && status != JobStatus::running; }

json job_document(const repository::JobRecord& job, const std::string& public_url) {
  const bool done = job.status == JobStatus::successful;
  json document{
      {"jobID", job.id.value},
      {"type", "process"},
      {"processID", job.process},
      {"status", repository::status_name(job.status)},
      {"message", job.message},
      {"progress", done ? 100 : std::clamp(static_cast<int>(std::floor(job.progress * 100.0)), 0, 100)},
      {"stage", job.stage},
      {"created", core::iso8601(job.created)},
      {"updated", core::iso8601(job.updated)},
      {"links", links(job, public_url)}};
  if (job.started) document["started"] = core::iso8601(*job.started);
  if (job.finished) document["finished"] = core::iso8601(*job.finished);
  return document;
}

}  // namespace floeplan::codec
