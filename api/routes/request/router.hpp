#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// Who may use an operation; a role includes the roles before it. `by_method`: depends on the HTTP method.
enum class Access { by_method, everybody, viewer, pilot, admin };

/// An operation on one kind of resource.
struct Route {
  std::string method;
  std::string pattern;                  // "/jobs/{job_id}"; "{path...}" at the end takes the rest of the path
  std::vector<std::string> parameters;  // known query parameters, besides "f"
  std::function<Response(const Context&, const Request&, const PathParameters&)> answer;
  Access access{Access::by_method};  // by_method: GET for viewers, all else for pilots
  bool keeps_own_keys{false};        // a POST that handles its Idempotency-Key itself
  bool gives_coverages{false};       // answers only in CoverageJSON
};

/// The least role for the operation; nullopt if everybody may use it.
[[nodiscard]] std::optional<repository::Role> least_role(const Route& route);

/// Finds the operation for a request. Answers itself: unknown paths (404), other methods (405 with Allow),
/// OPTIONS (204 with Allow), unidentified callers (401), callers without the role (403), unknown query
/// parameters and formats (400). HEAD is answered like GET. A POST with an Idempotency-Key is carried out
/// only once.
/// Errors   exceptions of an operation are not caught
/// Threads  may be called from several threads at once
class Router {
 public:
  explicit Router(std::vector<Route> routes);

  [[nodiscard]] Response answer(const Context& context, const Request& request) const;
  /// The refusal of a caller who may not use the operation; nullopt if the caller may, or there is no such
  /// operation.
  [[nodiscard]] std::optional<Response> refusal(const Request& request) const;
  [[nodiscard]] const std::vector<Route>& routes() const { return routes_; }

 private:
  std::vector<Route> routes_;
  std::vector<std::vector<std::string>> patterns_;  // for each route its pattern, split at slashes
};

/// Whether the body of a request is a file that is written to disk, not kept in memory.
[[nodiscard]] bool streams_body(const std::string& method, const std::string& path);

/// All operations of the service.
[[nodiscard]] std::vector<Route> all_routes();

/// The operations of a node that only works: health, readiness and metrics, for everybody.
[[nodiscard]] std::vector<Route> node_routes();

}  // namespace floeplan::routes
