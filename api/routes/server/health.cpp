#include "api/routes/request/reply.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/version.hpp"

namespace floeplan::routes {

std::vector<Route> health_routes() {
  const auto health = [](const Context&, const Request&, const PathParameters&) {
    return json_reply({{"status", "ok"}});
  };
  const auto version = [](const Context&, const Request&, const PathParameters&) {
    return json_reply({{"name", "floeplan"}, {"version", core::version()}});
  };
  return {{"GET", "/healthz", {}, health, Access::everybody}, {"GET", "/version", {}, version}};
}

}  // namespace floeplan::routes
