#include "api/codec/bytes/text_values.hpp"
#include "api/codec/documents/job_document.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"

namespace floeplan::routes {
namespace {

using repository::JobRecord;

constexpr core::Seconds heartbeat{15.0};  // proxies close connections without data for a minute
constexpr int most_at_once = 1000;

/// One event of an HTML event stream; its id is the number of the job's last change.
std::string event_of(const JobRecord& job, const std::string& public_url) {
  return "id: " + std::to_string(job.change) + "\nevent: job\ndata: " +
         codec::job_document(job, public_url).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n\n";
}

/// The number of the last change that the client has seen, from a Wait's token or from the request's header.
std::optional<std::int64_t> change_of(const std::string& text) {
  const auto change = codec::parse_integer(text);
  return change && *change >= 0 ? change : std::nullopt;
}

/// The client's Last-Event-ID; empty if the client has seen no event.
tl::expected<std::optional<std::int64_t>, Response> last_event(const Request& request) {
  const std::string text = request.header("last-event-id");
  if (text.empty()) return std::optional<std::int64_t>{};
  const auto change = change_of(text);
  if (!change)
    return tl::unexpected(invalid(request, {{"Last-Event-ID", "must be the id of an event of this server"}}));
  return change;
}

Response piece(std::string text) {
  Response response;
  response.content_type = "text/event-stream";
  response.headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}};
  response.body = std::move(text);
  response.streams = true;
  return response;
}

/// A piece of the stream, to be continued after the change `seen`; a comment if nothing has changed for the
/// heartbeat.
Response piece_of_more(const Request& request, std::string text, std::int64_t seen,
                       std::function<std::shared_ptr<void>(std::function<void()>)> subscribe) {
  const bool begins = !request.resumption;
  if (begins) text.insert(0, "retry: 2000\n\n");
  if (text.empty() && request.resumption->last) text = ": nothing new\n\n";
  Response response = piece(std::move(text));
  response.wait = Wait{heartbeat, std::to_string(seen), std::move(subscribe)};
  return response;
}

/// Streams the changes of all jobs from now on, or since the last event that the client has seen. A job that
/// changed several times in between is sent once, in its present state, so that nothing has to be stored for
/// a slow client.
Response stream_all(const Context& context, const Request& request, const PathParameters&) {
  const repository::JobRepository jobs{context.db};
  const auto last = last_event(request);
  if (!last) return last.error();
  std::int64_t seen = request.resumption ? change_of(request.resumption->token).value_or(0)
                                         : last->value_or(jobs.last_change());
  std::string text;
  for (const auto& job : jobs.changed_since(seen, most_at_once)) {
    text += event_of(job, context.service.public_url);
    seen = job.change;
  }
  return piece_of_more(request, std::move(text), seen, [gateway = &context.jobs](std::function<void()> wake) {
    return gateway->subscribe_to_all(std::move(wake));
  });
}

/// Streams one job until it has ended. A client that has seen the end gets 204, which tells it not to
/// reconnect.
Response stream_one(const Context& context, const Request& request, const PathParameters& path) {
  const repository::JobId id{path.at("job_id")};
  const auto job = repository::JobRepository{context.db}.find(id);
  if (!job) return request.resumption ? piece("") : no_such_job(request, id.value);
  const auto last = last_event(request);
  if (!last) return last.error();

  const std::int64_t seen =
      request.resumption ? change_of(request.resumption->token).value_or(-1) : last->value_or(-1);
  const bool is_new = job->change > seen;
  const bool ended = codec::is_finished(job->status);
  if (ended && !is_new && !request.resumption) {
    Response response;
    response.status = 204;
    return response;
  }
  std::string text = is_new ? event_of(*job, context.service.public_url) : "";
  if (ended) return piece(std::move(text));
  return piece_of_more(request, std::move(text), job->change,
                       [gateway = &context.jobs, id](std::function<void()> wake) {
                         return gateway->subscribe(id, std::move(wake));
                       });
}

}  // namespace

std::vector<Route> job_event_routes() {
  return {{"GET", "/events", {}, stream_all}, {"GET", "/jobs/{job_id}/events", {}, stream_one}};
}

}  // namespace floeplan::routes
