#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/objective.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "storage/repository/environment/environment_loader.hpp"

namespace floeplan::codec {

/// How long before a requested arrival the earliest departure is, if the request does not state one: the
/// longest glider mission requested in practice (Eichhorn 2010, doi:10.1109/OCEANS.2010.5664082).
inline constexpr core::Seconds longest_mission{30.0 * 86400.0};

/// Reads "depart", which is required.
void read_departure(InputReader& reader, planning::PlanRequest& request);

/// Reads "depart", with "depart_until" and "depart_step" for a window; or "arrive_by", where "depart" is the
/// earliest departure and optional.
void read_departures(InputReader& reader, planning::PlanRequest& request);
void write_departures(const planning::PlanRequest& request, nlohmann::json& inputs);

/// Sets the period that the request's data have to cover.
void fill_period(const planning::PlanRequest& request, repository::EnvironmentQuery& data);

/// Reads what to minimise and which propulsion to use: "objective" ("time", "energy" or weights of both),
/// "thruster" and "require_battery".
void read_energy(InputReader& reader, planning::EnergyRules& rules);
/// Adds the members that `read_energy` reads, with all defaults filled in.
void write_energy(const planning::EnergyRules& rules, nlohmann::json& inputs);

/// Reads the settings of the search: grid, method, objective, refinement.
void read_search(InputReader& reader, planning::PlanRequest& request);
/// Adds the members that `read_search` reads, with all defaults filled in.
void write_search(const planning::PlanRequest& request, nlohmann::json& inputs);

}  // namespace floeplan::codec
