#include <iterator>

#include "api/routes/request/resources.hpp"

namespace floeplan::routes {

std::vector<Route> all_routes() {
  std::vector<Route> all;
  for (auto* routes_of :
       {landing_routes,  asset_routes,     collection_routes, feature_routes,   iceberg_drift_routes,
        edr_routes,      edr_query_routes, plan_routes,       mission_routes,   mission_check_routes,
        process_routes,  execution_routes, job_routes,        job_event_routes, simulation_routes,
        dataset_routes,  upload_routes,    vehicle_routes,    probe_routes,     map_field_routes,
        coast_routes,    ice_chart_routes, health_routes,     session_routes,   audit_routes,
        operation_routes}) {
    auto routes = routes_of();
    std::move(routes.begin(), routes.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<Route> node_routes() {
  std::vector<Route> all = health_routes();
  for (Route& route : operation_routes()) all.push_back(std::move(route));
  for (Route& route : all) route.access = Access::everybody;
  return all;
}

}  // namespace floeplan::routes
