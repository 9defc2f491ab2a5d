#pragma once

#include <functional>

#include "api/routes/context.hpp"
#include "api/routes/job_gateway.hpp"
#include "api/routes/message.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::cli {

/// Joins the resources with store and job system: a handler that lends each call a connection of its own.
/// `jobs` is borrowed and outlives the handler.
[[nodiscard]] routes::Handler make_api_handler(std::function<sqlite::Connection()> open_store,
                                               routes::JobGateway& jobs, routes::ServiceInfo service);

}  // namespace floeplan::cli
