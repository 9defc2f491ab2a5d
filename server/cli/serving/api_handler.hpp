#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "api/routes/access/doorkeeper.hpp"
#include "api/routes/request/context.hpp"
#include "api/routes/request/job_gateway.hpp"
#include "api/routes/request/message.hpp"
#include "api/routes/request/router.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::cli {

/// The functions that the HTTP server needs from the API.
struct Api {
  routes::Handler answer;
  /// Answers that are available at once: very fast ones, and cached ones that are still valid; nullopt: call
  /// `answer`.
  std::function<std::optional<routes::Response>(const routes::Request&)> at_once;
  /// Identifies the client of a request.
  std::function<std::string(const routes::Request&)> client_of;
  /// The refusal of a caller who may not send this large body, before it is read.
  std::function<std::optional<routes::Response>(const routes::Request&)> refuse;
};

/// Connects these resources with the store and the job system. Each call of a handler uses its own connection.
/// `jobs` is borrowed and must live longer than the handlers.
[[nodiscard]] Api make_api(std::function<sql::Connection()> open_store, std::vector<routes::Route> routes,
                           routes::JobGateway& jobs, routes::ServiceInfo service, routes::Doors doors);

}  // namespace floeplan::cli
