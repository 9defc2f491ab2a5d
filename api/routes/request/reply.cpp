#include "api/routes/request/reply.hpp"

#include "api/codec/documents/problem.hpp"

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

Response problem_reply(const Request& request, const problems::Problem& problem) {
  const std::string accept = request.header("accept");
  const auto accepts = [&](const char* type) { return accept.find(type) != std::string::npos; };
  const bool plain_only =
      accepts("application/json") && !accepts("*/*") && !accepts("application/problem+json");
  return json_reply(codec::to_json(problem), problem.status,
                    plain_only ? "application/json" : "application/problem+json");
}

Response no_such_process(const Request& request, const std::string& id) {
  return problem_reply<"no-such-process">(request, id);
}

Response no_such_job(const Request& request, const std::string& id) {
  return problem_reply<"no-such-job">(request, id);
}

Response invalid(const Request& request, core::Violations violations) {
  return problem_reply(request, problems::problem<"invalid-request">().with(std::move(violations)));
}

json link(const std::string& rel, const std::string& type, const std::string& href,
          const std::string& title) {
  json result{{"rel", rel}, {"type", type}, {"href", href}};
  if (!title.empty()) result["title"] = title;
  return result;
}

}  // namespace floeplan::routes
