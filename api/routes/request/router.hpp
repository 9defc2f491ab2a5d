#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// Who may use an operation; the roles include those below them.
enum class Access { by_method, everybody, viewer, pilot, admin };

/// One operation on one kind of resource.
struct Route {
  std::string method;
  std::string pattern;                  // "/jobs/{job_id}"; a last "{path...}" takes the rest of the path
  std::vector<std::string> parameters;  // query parameters it knows, besides "f"
  std::function<Response(const Context&, const Request&, const PathParameters&)> answer;
  Access access{Access::by_method};  // reading is for viewers, everything else for pilots
  bool keeps_own_keys{false};        // of a POST: sees to its Idempotency-Key itself
  bool gives_coverages{false};       // as CoverageJSON, and in no other format
};

/// The least role that may use the operation; nothing when everybody may.
[[nodiscard]] std::optional<repository::Role> least_role(const Route& route);

/// Finds the operation for a request and answers what has none: unknown paths (404), other methods (405 with
/// Allow), OPTIONS (204 with Allow), callers whom nobody knows (401) or who may not (403), unknown query parameters and
/// formats (400). HEAD is answered as GET. A POST with an Idempotency-Key is done once.
/// Errors   what an operation throws leaves as it is
/// Threads  may be called from several threads at once
class Router {
 public:
  explicit Router(std::vector<Route> routes);

  [[nodiscard]] Response answer(const Context& context, const Request& request) const;
  /// The answer to a caller who may not use the operation asked for; nothing when he may, or when there is none.
  [[nodiscard]] std::optional<Response> refusal(const Request& request) const;
  [[nodiscard]] const std::vector<Route>& routes() const { return routes_; }

 private:
  std::vector<Route> routes_;
  std::vector<std::vector<std::string>> patterns_;  // of each route, cut at its slashes
};

/// Whether the body of a request is a file that belongs on the disk, not in memory.
[[nodiscard]] bool streams_body(const std::string& method, const std::string& path);

/// Every operation of the service.
[[nodiscard]] std::vector<Route> all_routes();

}  // namespace floeplan::routes
