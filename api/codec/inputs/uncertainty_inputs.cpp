#include "api/codec/inputs/uncertainty_inputs.hpp"

#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using planning::RobustObjective;

std::optional<std::string> objective_name(RobustObjective objective) {
  switch (objective) {
    case RobustObjective::none: return std::nullopt;
    case RobustObjective::mean: return "mean";
    case RobustObjective::quantile: return "quantile";
  }
  return std::nullopt;
}

json seconds_json(const std::optional<core::Seconds>& time) { return time ? json(time->count()) : json(); }

void read_error_model(InputReader& members, planning::UncertaintyRules& rules) {
  read_fields(members, fields::error_model_fields(), rules);
  const bool tells_errors = members.member("current_error_m_s") != nullptr ||
                            members.member("length_scale_m") != nullptr ||
                            members.member("time_scale_s") != nullptr || members.member("seed") != nullptr;
  if (tells_errors && members.member("members") == nullptr)
    members.refuse<"required-with">("/uncertainty/members", "an error model", "how many to draw, 2 to 64");
  if (members.member("members") != nullptr) {
    members.require_with("\"members\"", "current_error_m_s",
                         "the standard deviation of each component's error, m/s");
    members.require_with("\"members\"", "length_scale_m", "the correlation length of the error, metres");
    members.require_with("\"members\"", "time_scale_s", "the correlation time of the error, seconds");
  }
}

}  // namespace

planning::UncertaintyRules read_uncertainty(InputReader& reader) {
  planning::UncertaintyRules rules;
  const json* value = reader.member("uncertainty");
  if (value == nullptr) return rules;
  InputReader members{*value, "/uncertainty"};
  read_error_model(members, rules);
  read_fields(members, fields::robustness_fields(), rules);
  // Stored inputs of older versions contain "quantile" with any objective, also with null; that is accepted.
  if (members.member("quantile") != nullptr && !value->contains("objective") &&
      !members.refused("/uncertainty/quantile"))
    members.refuse_member<"quantile-without-use">("quantile");
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
  return rules;
}

json uncertainty_json(const planning::UncertaintyRules& rules) {
  const bool drawn = rules.drawn_members > 0;
  if (!drawn && rules.objective == RobustObjective::none && !rules.arrive_before) return nullptr;
  json result;
  write_fields(fields::robustness_fields(), rules, result);
  if (rules.objective != RobustObjective::quantile) result["quantile"] = nullptr;
  if (drawn) write_fields(fields::error_model_fields(), rules, result);
  return result;
}

json uncertainty_document(const planning::UncertaintyReport& report) {
  const planning::ArrivalSpread& spread = report.spread;
  json members = json::array();
  for (const auto& time : spread.travel_times()) members.push_back(seconds_json(time));
  const auto objective = objective_name(report.objective);
  return {{"members", spread.travel_times().size()},
          {"arrived", spread.arrived()},
          {"mean_s", seconds_json(spread.mean())},
          {"standard_deviation_s", seconds_json(spread.standard_deviation())},
          {"quantiles_s",
           {{"p10", seconds_json(spread.quantile(0.1))},
            {"p50", seconds_json(spread.quantile(0.5))},
            {"p90", seconds_json(spread.quantile(0.9))}}},
          {"objective", objective ? json(*objective) : json()},
          {"quantile", report.objective == RobustObjective::quantile ? json(report.quantile) : json()},
          {"candidates", report.candidates},
          {"arrive_before", report.arrive_before ? json(core::iso8601(*report.arrive_before)) : json()},
          {"chance", report.chance ? json(*report.chance) : json()},
          {"travel_times_s", std::move(members)}};
}

std::optional<planning::UncertaintyReport> parse_uncertainty_document(const json& document) {
  if (document.is_null()) return std::nullopt;
  std::vector<std::optional<core::Seconds>> members;
  for (const json& time_s : document.at("travel_times_s"))
    members.push_back(time_s.is_null() ? std::nullopt : std::optional{core::Seconds{time_s.get<double>()}});
  planning::UncertaintyReport report{.spread = planning::ArrivalSpread{std::move(members)},
                                     .candidates = document.at("candidates").get<std::size_t>(),
                                     .arrive_before = {},
                                     .chance = {}};
  for (const RobustObjective objective : {RobustObjective::mean, RobustObjective::quantile})
    if (document.at("objective") == json(objective_name(objective).value_or("")))
      report.objective = objective;
  if (const json& quantile = document.at("quantile"); !quantile.is_null())
    report.quantile = quantile.get<double>();
  if (const json& wanted = document.at("arrive_before"); !wanted.is_null())
    report.arrive_before = core::parse_iso8601(wanted.get<std::string>());
  if (const json& chance = document.at("chance"); !chance.is_null()) report.chance = chance.get<double>();
  return report;
}

}  // namespace floeplan::codec
