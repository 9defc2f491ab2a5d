#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/objective.hpp"

namespace floeplan::codec {

/// What to save and what to drive with: "objective" ("time", "energy" or weights of both), "thruster" and
/// "require_battery".
void read_energy(InputReader& reader, planning::EnergyRules& rules);
/// Adds the members that `read_energy` reads, every default written out.
void write_energy(const planning::EnergyRules& rules, nlohmann::json& inputs);

}  // namespace floeplan::codec
