#include "api/routes/reply.hpp"

namespace floeplan::routes {

using nlohmann::json;

Response json_reply(const json& document, int status, const std::string& content_type) {
  Response response;
  response.status = status;
  response.content_type = content_type;
  response.body = document.dump(-1, ' ', false, json::error_handler_t::replace);
  return response;
}

Response geojson_reply(const json& document) { return json_reply(document, 200, "application/geo+json"); }

Response problem_reply(const Request& request, const codec::Problem& problem) {
  const std::string accept = request.header("accept");
  const auto accepts = [&](const char* type) { return accept.find(type) != std::string::npos; };
  const bool plain_only =
      accepts("application/json") && !accepts("*/*") && !accepts("application/problem+json");
  return json_reply(codec::to_json(problem), problem.status,
                    plain_only ? "application/json" : "application/problem+json");
}

Response not_found(const Request& request, const std::string& slug, const std::string& detail) {
  return problem_reply(request, {404, slug, "Not found", detail, {}});
}

Response no_such_process(const Request& request, const std::string& id) {
  return not_found(request, "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-process",
                   "No process has the id " + id + ".");
}

Response no_such_job(const Request& request, const std::string& id) {
  return not_found(request, "http://www.opengis.net/def/exceptions/ogcapi-processes-1/1.0/no-such-job",
                   "No job has the id " + id + ".");
}

Response invalid(const Request& request, core::Violations violations) {
  return problem_reply(request,
                       {400, "invalid-request", "Invalid request",
                        "The request has faults; each is listed under \"errors\".", std::move(violations)});
}

json link(const std::string& rel, const std::string& type, const std::string& href,
          const std::string& title) {
  json result{{"rel", rel}, {"type", type}, {"href", href}};
  if (!title.empty()) result["title"] = title;
  return result;
}

}  // namespace floeplan::routes
