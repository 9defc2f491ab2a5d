#pragma once

#include <vector>

#include "api/routes/request/router.hpp"

namespace floeplan::routes {

/// The operations of each resource; each function has its own source file.
[[nodiscard]] std::vector<Route> landing_routes();        // landing page, conformance, OpenAPI document
[[nodiscard]] std::vector<Route> asset_routes();          // files of the browser client
[[nodiscard]] std::vector<Route> collection_routes();     // descriptions of the feature collections
[[nodiscard]] std::vector<Route> feature_routes();        // items, schemas and changes of every collection
[[nodiscard]] std::vector<Route> iceberg_drift_routes();  // forecast positions of icebergs
[[nodiscard]] std::vector<Route> edr_routes();            // landing page and collections of OGC API - EDR
// queries of position, radius, area, cube and trajectory
[[nodiscard]] std::vector<Route> edr_query_routes();
[[nodiscard]] std::vector<Route> plan_routes();           // checks, inputs and removal of plans
[[nodiscard]] std::vector<Route> mission_routes();        // a plan as files for vehicles and chart plotters
[[nodiscard]] std::vector<Route> mission_check_routes();  // checks of mission files from outside
[[nodiscard]] std::vector<Route> process_routes();        // list and descriptions of processes
[[nodiscard]] std::vector<Route> execution_routes();      // POST that starts a job
[[nodiscard]] std::vector<Route> job_routes();
[[nodiscard]] std::vector<Route> job_event_routes();   // server-sent events of jobs
[[nodiscard]] std::vector<Route> simulation_routes();  // simulated flights of plans
[[nodiscard]] std::vector<Route> dataset_routes();
[[nodiscard]] std::vector<Route> upload_routes();
[[nodiscard]] std::vector<Route> vehicle_routes();
[[nodiscard]] std::vector<Route> probe_routes();
[[nodiscard]] std::vector<Route> map_field_routes();  // bathymetry and currents as binary grids
[[nodiscard]] std::vector<Route> coast_routes();
[[nodiscard]] std::vector<Route> ice_chart_routes();  // polygons of a chart with their egg codes
[[nodiscard]] std::vector<Route> health_routes();     // health and version
[[nodiscard]] std::vector<Route> operation_routes();  // metrics and readiness
[[nodiscard]] std::vector<Route> session_routes();    // logins from a browser
[[nodiscard]] std::vector<Route> audit_routes();      // the audit log

}  // namespace floeplan::routes
