#include "api/routes/reply.hpp"
#include "api/routes/resources.hpp"

namespace floeplan::routes {

std::vector<Route> health_routes() {
  const auto health = [](const Context&, const Request&, const PathParameters&) {
    return json_reply({{"status", "ok"}});
  };
  const auto version = [](const Context&, const Request&, const PathParameters&) {
    return json_reply({{"name", "floeplan"}, {"version", FLOEPLAN_VERSION}});
  };
  return {{"GET", "/healthz", {}, health, Access::everybody}, {"GET", "/version", {}, version}};
}

}  // namespace floeplan::routes
