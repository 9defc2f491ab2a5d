#include "api/routes/router.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "api/routes/idempotency.hpp"
#include "api/routes/reply.hpp"

namespace floeplan::routes {
namespace {

std::vector<std::string_view> segments(std::string_view path) {
  std::vector<std::string_view> result;
  while (!path.empty()) {
    path.remove_prefix(1);  // the slash
    const auto end = std::min(path.find('/'), path.size());
    result.push_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return result;
}

std::optional<PathParameters> match(std::string_view pattern, std::string_view path) {
  const auto wanted = segments(pattern);
  const auto given = segments(path);
  PathParameters parameters;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i >= given.size()) return std::nullopt;
    const auto part = wanted[i];
    if (part.ends_with("...}")) {
      parameters[std::string{part.substr(1, part.size() - 5)}] = path.substr(given[i].data() - path.data());
      return parameters;
    }
    if (part.starts_with('{')) {
      if (given[i].empty()) return std::nullopt;
      parameters[std::string{part.substr(1, part.size() - 2)}] = given[i];
    } else if (part != given[i]) {
      return std::nullopt;
    }
  }
  return wanted.size() == given.size() ? std::optional{parameters} : std::nullopt;
}

/// The first thing wrong with the query that concerns every operation.
std::optional<core::Violation> query_fault(const Route& route, const Request& request) {
  constexpr std::array known_formats{"json",
                                     "html",
                                     "geojson",
                                     "text/html",
                                     "application/json",
                                     "application/geo+json",
                                     "CoverageJSON",
                                     "covjson",
                                     "application/vnd.cov+json",
                                     "application/prs.coverage+json"};
  for (const auto& [name, value] : request.query) {
    if (name == "f") {
      if (std::find(known_formats.begin(), known_formats.end(), value) == known_formats.end()) {
        return core::Violation{"?f", "must be json or html"};
      }
    } else if (std::find(route.parameters.begin(), route.parameters.end(), name) == route.parameters.end()) {
      return core::Violation{"?" + name, "the query parameter \"" + name + "\" is not known here"};
    }
  }
  return std::nullopt;
}

Response without_operation(const Request& request, const std::vector<std::string>& methods) {
  if (methods.empty()) return not_found(request, "unknown-path", "There is nothing at " + request.path + ".");

  std::string allow = "OPTIONS";
  for (const auto& method : methods) {
    allow += ", " + method;
    if (method == "GET") allow += ", HEAD";
  }
  Response response;
  if (request.method == "OPTIONS") {
    response.status = 204;
  } else {
    response = problem_reply(request, {405,
                                       "method-not-allowed",
                                       "Method not allowed",
                                       request.method + " is not possible here; allowed: " + allow + ".",
                                       {}});
  }
  response.headers.emplace_back("Allow", allow);
  return response;
}

Response answer_by(const Route& route, const Context& context, const Request& request,
                   const PathParameters& path) {
  if (route.method != "POST" || route.keeps_own_keys) return route.answer(context, request, path);
  const auto key = idempotency_key(request);
  if (!key) return key.error();
  if (!*key) return route.answer(context, request, path);
  return answer_once(context, request, **key, [&] { return route.answer(context, request, path); });
}

}  // namespace

Response Router::answer(const Context& context, const Request& request) const {
  std::string path = request.path;
  if (path.size() > 1 && path.ends_with('/')) path.pop_back();
  const std::string method = request.method == "HEAD" ? "GET" : request.method;

  std::vector<std::string> methods;
  for (const auto& route : routes_) {
    const auto parameters = path.starts_with('/') ? match(route.pattern, path) : std::nullopt;
    if (!parameters) continue;
    if (route.method != method) {
      if (std::find(methods.begin(), methods.end(), route.method) == methods.end())
        methods.push_back(route.method);
      continue;
    }
    if (const auto fault = query_fault(route, request)) return invalid(request, {*fault});
    return answer_by(route, context, request, *parameters);
  }
  return without_operation(request, methods);
}

}  // namespace floeplan::routes
