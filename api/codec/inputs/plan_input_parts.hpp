#pragma once

#include <nlohmann/json_fwd.hpp>
#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "storage/repository/environment/environment_loader.hpp"
#include "engine/planning/problem/objective.hpp"

namespace floeplan::codec {

/// Earliest departure when a request asks for an arrival and names none: the longest mission of a glider that was
/// asked for in practice (Eichhorn 2010, doi:10.1109/OCEANS.2010.5664082).
inline constexpr core::Seconds longest_mission{30.0 * 86400.0};

/// "depart", which is required.
void read_departure(InputReader& reader, planning::PlanRequest& request);

/// "depart" with "depart_until" and "depart_step" for a window, or "arrive_by", with which "depart" is the earliest
/// departure and may be left out.
void read_departures(InputReader& reader, planning::PlanRequest& request);
void write_departures(const planning::PlanRequest& request, nlohmann::json& inputs);

/// The period that the data of the request have to cover.
void fill_period(const planning::PlanRequest& request, repository::EnvironmentQuery& data);

/// What to save and what to drive with: "objective" ("time", "energy" or weights of both), "thruster" and
/// "require_battery".
void read_energy(InputReader& reader, planning::EnergyRules& rules);
/// Adds the members that `read_energy` reads, every default written out.
void write_energy(const planning::EnergyRules& rules, nlohmann::json& inputs);

/// How to search: grid, method, objective, refinement.
void read_search(InputReader& reader, planning::PlanRequest& request);
/// Adds the members that `read_search` reads, every default written out.
void write_search(const planning::PlanRequest& request, nlohmann::json& inputs);

}  // namespace floeplan::codec
