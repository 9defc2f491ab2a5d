#pragma once

#include <vector>

#include "api/fields/table.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/isochrone_request.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/uncertainty_rules.hpp"
#include "engine/planning/problem/under_ice_rules.hpp"
#include "engine/vehicle/energy_model.hpp"
#include "engine/vehicle/flight_choices.hpp"
#include "engine/vehicle/glider_profile.hpp"
#include "storage/repository/environment/environment_loader.hpp"

/// The table of request fields, in parts. JSON is read and written according to it
/// (api/codec/reading/input_fields). The options of the command line are derived from it
/// (server/cli/program/input_flags), and the schemas of the OpenAPI document and the forms of the client must
/// agree with it (tests/api/fields/contract_test). Names of fields and flags never change.
/// Threads  the tables are created once and then only read
namespace floeplan::fields {

// Fields of plan-route.
[[nodiscard]] const std::vector<Field>& way_fields();  // start, goal and via points, and vehicle
[[nodiscard]] const Table<planning::PlanRequest>& order_fields();
[[nodiscard]] const Table<planning::PlanRequest>& leg_fields();  // how many legs, how long
[[nodiscard]] const std::vector<Field>& departure_fields();
[[nodiscard]] const std::vector<Field>& window_fields();
[[nodiscard]] const Table<planning::PlanRequest>& alternative_fields();
[[nodiscard]] const std::vector<Field>& grid_fields();
[[nodiscard]] const Table<planning::PlanRequest>& search_fields();
[[nodiscard]] const Table<planning::UncertaintyRules>& error_model_fields();
[[nodiscard]] const Table<planning::UncertaintyRules>& robustness_fields();
[[nodiscard]] const Table<planning::IcebergRules>& encounter_fields();

// Fields of evaluate-route and of reach.
[[nodiscard]] const std::vector<Field>& given_route_fields();  // which route to evaluate
[[nodiscard]] const std::vector<Field>& isochrone_fields();
[[nodiscard]] const Table<planning::IsochroneRequest>& isochrone_grid_fields();

// Rules for a route.
[[nodiscard]] const std::vector<Field>& objective_fields();
[[nodiscard]] const Table<planning::Objective>& weight_fields();
[[nodiscard]] const Table<planning::EnergyRules>& energy_fields();
[[nodiscard]] const Table<planning::PlanRequest>& hold_fields();
[[nodiscard]] const Table<planning::IcebergRules>& margin_fields();
[[nodiscard]] const Table<planning::IcebergRules>& iceberg_fields();
[[nodiscard]] const Table<repository::EnvironmentQuery>& sighting_fields();
[[nodiscard]] const Table<planning::UnderIceRules>& passing_under_ice_fields();
[[nodiscard]] const Table<planning::UnderIceRules>& surfacing_fields();
[[nodiscard]] const std::vector<Field>& area_fields();

// Vehicle and data.
[[nodiscard]] const std::vector<Field>& vehicle_fields();
/// Choice of a vehicle by its name.
[[nodiscard]] const std::vector<Field>& profile_fields();
/// Settings that a pilot changes between missions.
[[nodiscard]] const Table<vehicle::FlightChoices>& flight_fields();
/// The vehicle's build: members of the object `vehicle`.
[[nodiscard]] const Table<vehicle::GliderProfile>& build_fields();
[[nodiscard]] const Table<vehicle::Thruster>& thruster_fields();
[[nodiscard]] const Table<repository::EnvironmentQuery>& data_fields();

// Names and remarks, which do not influence the result.
[[nodiscard]] const std::vector<Field>& name_fields();
[[nodiscard]] const std::vector<Field>& remark_fields();

}  // namespace floeplan::fields
