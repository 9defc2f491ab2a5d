#pragma once

#include <string>

#include "api/problems/problem_catalogue.hpp"
#include "api/routes/request/message.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {

/// A response with a JSON document. Invalid UTF-8 in texts from outside is replaced.
[[nodiscard]] Response json_reply(const nlohmann::json& document, int status = 200,
                                  const std::string& content_type = "application/json");

[[nodiscard]] Response geojson_reply(const nlohmann::json& document);

/// The problem as application/problem+json, or as application/json if the request accepts only that.
[[nodiscard]] Response problem_reply(const Request& request, const problems::Problem& problem);
/// The reply with the problem of this code and these values.
template <messages::Code code, class... Given>
[[nodiscard]] Response problem_reply(const Request& request, const Given&... given) {
  return problem_reply(request, problems::problem<code>(given...));
}

[[nodiscard]] Response no_such_process(const Request& request, const std::string& id);
[[nodiscard]] Response no_such_job(const Request& request, const std::string& id);
[[nodiscard]] Response invalid(const Request& request, core::Violations violations);

/// A link in OGC API documents.
[[nodiscard]] nlohmann::json link(const std::string& rel, const std::string& type, const std::string& href,
                                  const std::string& title = "");

}  // namespace floeplan::routes
