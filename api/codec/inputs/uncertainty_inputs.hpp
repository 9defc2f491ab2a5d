#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "api/codec/reading/input_reader.hpp"
#include "engine/planning/problem/uncertainty_report.hpp"
#include "engine/planning/problem/uncertainty_rules.hpp"

namespace floeplan::codec {

/// Reads the member `uncertainty`: an error model of the currents (members, current_error_m_s,
/// length_scale_m, time_scale_s, seed), what to optimise (objective "mean" or "quantile", quantile), and
/// arrive_before. If the request names several currents, these are the members and no errors are drawn.
[[nodiscard]] planning::UncertaintyRules read_uncertainty(InputReader& reader);
/// The rules as JSON; null if the request has none.
[[nodiscard]] nlohmann::json uncertainty_json(const planning::UncertaintyRules& rules);
/// The result's member `uncertainty`.
[[nodiscard]] nlohmann::json uncertainty_document(const planning::UncertaintyReport& report);
/// Reads it back; nullopt for null.
/// Errors   nlohmann::json::exception and std::runtime_error if it is not the result's member
[[nodiscard]] std::optional<planning::UncertaintyReport> parse_uncertainty_document(
    const nlohmann::json& document);

}  // namespace floeplan::codec
