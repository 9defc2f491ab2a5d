#pragma once

#include <functional>
#include <optional>

#include "api/routes/access/doorkeeper.hpp"
#include "api/routes/request/context.hpp"
#include "api/routes/request/job_gateway.hpp"
#include "api/routes/request/message.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::cli {

/// What a server asks of the API.
struct Api {
  routes::Handler answer;
  /// What is answered as soon as it is read, or was answered before and has not changed; nothing: ask `answer`.
  std::function<std::optional<routes::Response>(const routes::Request&)> at_once;
  /// Who is one client to the server.
  std::function<std::string(const routes::Request&)> client_of;
  /// Before a large body is taken in: the refusal of whoever may not send it.
  std::function<std::optional<routes::Response>(const routes::Request&)> refuse;
};

/// Joins the resources with store and job system: handlers that lend each call a connection of its own.
/// `jobs` is borrowed and outlives them.
[[nodiscard]] Api make_api(std::function<sql::Connection()> open_store, routes::JobGateway& jobs,
                           routes::ServiceInfo service, routes::Doors doors);

}  // namespace floeplan::cli
