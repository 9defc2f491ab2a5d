#include "api/routes/request/router.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "api/routes/request/idempotency.hpp"
#include "api/routes/request/reply.hpp"
#include "engine/messages/fault.hpp"

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

bool is_parameter(std::string_view part) { return part.starts_with('{'); }

bool takes_the_rest(std::string_view part) { return part.ends_with("...}"); }

/// Whether a path matches a pattern. Called for every route and request, so it allocates nothing.
bool matches(const std::vector<std::string>& pattern, const std::vector<std::string_view>& given) {
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (i >= given.size()) return false;
    if (takes_the_rest(pattern[i])) return true;
    if (is_parameter(pattern[i]) ? given[i].empty() : pattern[i] != given[i]) return false;
  }
  return pattern.size() == given.size();
}

/// The values of the parameters in a path that matches the pattern.
PathParameters parameters_of(const std::vector<std::string>& pattern,
                             const std::vector<std::string_view>& given, std::string_view path) {
  PathParameters parameters;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const std::string_view part = pattern[i];
    if (takes_the_rest(part)) {
      parameters[std::string{part.substr(1, part.size() - 5)}] = path.substr(given[i].data() - path.data());
    } else if (is_parameter(part)) {
      parameters[std::string{part.substr(1, part.size() - 2)}] = given[i];
    }
  }
  return parameters;
}

std::string without_last_slash(std::string path) {
  if (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

/// Whether `format` is one of the known ones; upper and lower case are equal.
bool is_one_of(std::string_view format, std::span<const std::string_view> known) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::any_of(known, [&](std::string_view candidate) {
    return std::ranges::equal(format, candidate, {}, lower, lower);
  });
}

/// Whether the operation answers in the format.
bool answers_in(const Route& route, std::string_view format) {
  constexpr std::array<std::string_view, 5> of_coverages{
      "CoverageJSON", "covjson", "json", "application/vnd.cov+json", "application/prs.coverage+json"};
  constexpr std::array<std::string_view, 6> of_others{
      "json", "html", "geojson", "text/html", "application/json", "application/geo+json"};
  if (is_one_of(format, of_coverages) || (route.gives_coverages && format == "application/json")) return true;
  return !route.gives_coverages && is_one_of(format, of_others);
}

/// The first fault of the query that is common to all operations: an unknown parameter or format.
std::optional<core::Violation> query_fault(const Route& route, const Request& request) {
  for (const auto& [name, value] : request.query) {
    if (name == "f") {
      if (!answers_in(route, value))
        return route.gives_coverages ? messages::fault<"not-a-format-of-coverages">("?f")
                                     : messages::fault<"not-a-format">("?f");
    } else if (std::find(route.parameters.begin(), route.parameters.end(), name) == route.parameters.end()) {
      return messages::fault<"unknown-query-parameter">("?" + name, name);
    }
  }
  return std::nullopt;
}

Response unknown_caller(const Request& request) {
  Response response = problem_reply<"unauthorized">(request);
  response.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"floeplan\"");
  return response;
}

std::optional<Response> refuse_caller(const Route& route, const Request& request) {
  const auto least = least_role(route);
  if (!least) return std::nullopt;
  if (!request.caller) return unknown_caller(request);
  if (request.caller->role >= *least) return std::nullopt;
  return problem_reply<"forbidden">(request, repository::role_name(*least),
                                    repository::role_name(request.caller->role));
}

Response without_operation(const Request& request, const std::vector<std::string>& methods) {
  if (methods.empty()) return problem_reply<"unknown-path">(request, request.path);

  std::string allow = "OPTIONS";
  for (const auto& method : methods) {
    allow += ", " + method;
    if (method == "GET") allow += ", HEAD";
  }
  Response response;
  if (request.method == "OPTIONS") {
    response.status = 204;
  } else {
    response = problem_reply<"method-not-allowed">(request, request.method, allow);
  }
  response.headers.emplace_back("Allow", allow);
  return response;
}

Response answer_from_store(const Route& route, const Context& context, const Request& request,
                           const PathParameters& path) {
  if (const Response* known = context.remembered->find(request)) return *known;
  Response response = route.answer(context, request, path);
  context.remembered->keep(request, response);
  return response;
}

Response answer_by(const Route& route, const Context& context, const Request& request,
                   const PathParameters& path) {
  if (auto refusal = refuse_caller(route, request)) return std::move(*refusal);
  if (const auto fault = query_fault(route, request)) return invalid(request, {*fault});
  if (context.remembered != nullptr && follows_from_store(request))
    return answer_from_store(route, context, request, path);
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

Router::Router(std::vector<Route> routes) : routes_{std::move(routes)} {
  for (const auto& route : routes_) {
    const auto parts = segments(route.pattern);
    patterns_.emplace_back(parts.begin(), parts.end());
  }
}

std::optional<Response> Router::refusal(const Request& request) const {
  const std::string path = without_last_slash(request.path);
  if (!path.starts_with('/')) return std::nullopt;
  const auto given = segments(path);
  for (std::size_t i = 0; i < routes_.size(); ++i) {
    if (routes_[i].method == request.method && matches(patterns_[i], given))
      return refuse_caller(routes_[i], request);
  }
  return std::nullopt;
}

Response Router::answer(const Context& context, const Request& request) const {
  const std::string path = without_last_slash(request.path);
  const std::string method = request.method == "HEAD" ? "GET" : request.method;

  std::vector<std::string> methods;
  if (!path.starts_with('/')) return without_operation(request, methods);
  const auto given = segments(path);
  for (std::size_t i = 0; i < routes_.size(); ++i) {
    const Route& route = routes_[i];
    if (!matches(patterns_[i], given)) continue;
    if (route.method != method) {
      if (std::find(methods.begin(), methods.end(), route.method) == methods.end())
        methods.push_back(route.method);
      continue;
    }
    Response response = answer_by(route, context, request, parameters_of(patterns_[i], given, path));
    response.route = route.pattern;
    return response;
  }
  return without_operation(request, methods);
}

}  // namespace floeplan::routes
