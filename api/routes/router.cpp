#include "api/routes/router.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

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

std::string without_last_slash(std::string path) {
  if (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
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

Response unknown_caller(const Request& request) {
  Response response =
      problem_reply(request, {401,
                              "unauthorized",
                              "Unauthorized",
                              "Nobody is known who asks; send a token as \"Authorization: Bearer "
                              "TOKEN\", or log in with it by POST /session.",
                              {}});
  response.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"floeplan\"");
  return response;
}

std::optional<Response> refuse_caller(const Route& route, const Request& request) {
  const auto least = least_role(route);
  if (!least) return std::nullopt;
  if (!request.caller) return unknown_caller(request);
  if (request.caller->role >= *least) return std::nullopt;
  return problem_reply(request,
                       {403,
                        "forbidden",
                        "Forbidden",
                        "This takes a token of the role " + repository::role_name(*least) +
                            "; yours is of the role " + repository::role_name(request.caller->role) + ".",
                        {}});
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
  if (auto refusal = refuse_caller(route, request)) return std::move(*refusal);
  if (const auto fault = query_fault(route, request)) return invalid(request, {*fault});
  if (route.method != "POST" || route.keeps_own_keys) return route.answer(context, request, path);
  const auto key = idempotency_key(request);
  if (!key) return key.error();
  if (!*key) return route.answer(context, request, path);
  return answer_once(context, request, **key, [&] { return route.answer(context, request, path); });
}

}  // namespace

std::optional<repository::Role> least_role(const Route& route) {
  switch (route.access) {
    case Access::everybody: return std::nullopt;
    case Access::viewer: return repository::Role::viewer;
    case Access::pilot: return repository::Role::pilot;
    case Access::admin: return repository::Role::admin;
    case Access::by_method: return route.method == "GET" ? repository::Role::viewer : repository::Role::pilot;
  }
  throw std::logic_error{"Access without a role"};
}

std::optional<Response> Router::refusal(const Request& request) const {
  const std::string path = without_last_slash(request.path);
  for (const auto& route : routes_) {
    if (route.method == request.method && path.starts_with('/') && match(route.pattern, path))
      return refuse_caller(route, request);
  }
  return std::nullopt;
}

Response Router::answer(const Context& context, const Request& request) const {
  const std::string path = without_last_slash(request.path);
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
    Response response = answer_by(route, context, request, *parameters);
    response.route = route.pattern;
    return response;
  }
  return without_operation(request, methods);
}

}  // namespace floeplan::routes
