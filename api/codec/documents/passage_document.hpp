#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/planning/problem/plan.hpp"

namespace floeplan::codec {

/// The icebergs that a plan passes under, as an array, and back.
[[nodiscard]] nlohmann::json passed_under_json(const std::vector<planning::PassedUnder>& passed);
[[nodiscard]] std::vector<planning::PassedUnder> parse_passed_under(const nlohmann::json& document);

/// The effect of the weight on encounters: the plan without it, and the plan; null if there was no weight.
[[nodiscard]] nlohmann::json encounter_trade_json(const planning::Plan& plan);
[[nodiscard]] std::optional<planning::EncounterTrade> parse_encounter_trade(const nlohmann::json& document);

}  // namespace floeplan::codec
