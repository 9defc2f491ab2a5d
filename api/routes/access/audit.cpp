#include "api/routes/access/audit.hpp"

#include <array>
#include <string_view>

#include "api/log/log.hpp"
#include "api/routes/request/paging.hpp"
#include "api/routes/request/parameters.hpp"
#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/repository/access/audit_repository.hpp"

namespace floeplan::routes {
namespace {

using nlohmann::json;

std::string location_of(const Response& response) {
  for (const auto& [name, value] : response.headers)
    if (name == "Location") return value;
  return {};
}

/// The process in the path of an execution: "plan-route" in "/processes/plan-route/execution".
std::optional<std::string> process_of(const std::string& path) {
  constexpr std::string_view begin = "/processes/";
  constexpr std::string_view end = "/execution";
  if (path.size() <= begin.size() + end.size() || !path.starts_with(begin) || !path.ends_with(end))
    return std::nullopt;
  return path.substr(begin.size(), path.size() - begin.size() - end.size());
}

/// Whether a path is a download for vehicles, chart plotters or printing. The map's requests for a plan are
/// not exports.
bool is_export(const std::string& path) {
  constexpr std::array<std::string_view, 2> files{"/mission", "/tracks."};
  const auto slash = path.find_last_of('/');
  return std::any_of(files.begin(), files.end(), [&](std::string_view name) {
    return slash != std::string::npos && std::string_view{path}.substr(slash).starts_with(name);
  });
}

Deed post_of(const Request& request, const Response& response) {
  const std::string target = response.wait ? "/jobs/" + response.wait->token : location_of(response);
  if (const auto process = process_of(request.path)) return {*process, target};
  if (request.path.starts_with("/uploads")) return {"upload", target};
  if (request.path == "/datasets/prune")
    return {"remove", request.path + " " + json::parse(request.body).dump()};
  return {"add", target.empty() ? request.path : target};
}

Response list_entries(const Context& context, const Request& request, const PathParameters&) {
  ParameterReader reader{request};
  const int limit = std::min(reader.limit(), 1000);
  const auto before = reader.integer("before", 0, INT64_MAX).value_or(0);
  if (!reader.violations().empty()) return invalid(request, reader.violations());

  const std::string& url = context.service.public_url;
  const auto entries = repository::AuditRepository{context.db}.list(before, limit);
  json list = json::array();
  for (const auto& entry : entries) {
    list.push_back({{"at", core::iso8601(entry.at)},
                    {"caller", entry.caller},
                    {"peer", entry.peer},
                    {"action", entry.action},
                    {"target", entry.target},
                    {"request_id", entry.request_id}});
  }
  json links = json::array({link("self", "application/json", address_of(request, url))});
  if (entries.size() == static_cast<std::size_t>(limit)) {
    links.push_back(link("next", "application/json",
                         address_with(request, url, "before", std::to_string(entries.back().row))));
  }
  return json_reply({{"entries", std::move(list)}, {"links", std::move(links)}});
}

}  // namespace

std::optional<Deed> deed_of(const Request& request, const Response& response) {
  const bool first_look = !request.resumption;  // a waiting request was recorded at its start
  if (response.status >= 400 || !first_look) return std::nullopt;
  if (request.method == "POST") {
    if (request.path == "/missions/check" || request.path == "/session") return std::nullopt;
    return post_of(request, response);
  }
  if (request.method == "DELETE")
    return Deed{request.path == "/session" ? "log-out" : "remove", request.path};
  if (request.method == "PUT" || request.method == "PATCH") return Deed{"change", request.path};
  if (request.method == "GET" && is_export(request.path)) return Deed{"export", request.path};
  return std::nullopt;
}

void write_down(const Context& context, const Request& request, const Response& response) {
  const auto deed = deed_of(request, response);
  if (!deed) return;
  try {
    constexpr std::size_t longest = 500;
    repository::AuditRepository{context.db}.add(
        {.at = request.now,
         .caller = request.caller ? request.caller->name : "",
         .peer = request.peer,
         .action = deed->action.substr(0, longest),
         .target = core::without_secrets(deed->target).substr(0, longest),
         .request_id = request.id});
  } catch (const std::exception& error) {
    log::error({"request=", request.id, " what was done could not be written down: ", error.what()});
  }
}

std::vector<Route> audit_routes() {
  return {{"GET", "/audit", {"limit", "before"}, list_entries, Access::admin}};
}

}  // namespace floeplan::routes
