#include "api/codec/uncertainty_inputs.hpp"

#include "api/codec/input_limits.hpp"
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
  rules.drawn_members = members.integer("members", 2, 64).value_or(0);
  const bool tells_errors = members.member("current_error_m_s") != nullptr ||
                            members.member("length_scale_m") != nullptr ||
                            members.member("time_scale_s") != nullptr || members.member("seed") != nullptr;
  if (tells_errors && members.member("members") == nullptr)
    members.refuse("/uncertainty/members", "is required with an error model: how many to draw, 2 to 64");
  if (members.member("members") != nullptr) {
    members.require("current_error_m_s",
                    "is required with \"members\": the standard deviation of each component's error, m/s");
    members.require("length_scale_m",
                    "is required with \"members\": over how far the error is alike, metres");
    members.require("time_scale_s",
                    "is required with \"members\": over how long the error is alike, seconds");
  }
  rules.error.standard_deviation = {members.number("current_error_m_s", {1e-3, 2.0}).value_or(0.0)};
  rules.error.length_scale = {members.number("length_scale_m", {1e3, 1e6}).value_or(0.0)};
  rules.error.time_scale = core::Seconds{members.number("time_scale_s", {600.0, 2'592'000.0}).value_or(0.0)};
  if (const auto seed = members.integer("seed", 0, largest_seed))
    rules.seed = static_cast<std::uint64_t>(*seed);
}

}  // namespace

planning::UncertaintyRules read_uncertainty(InputReader& reader) {
  planning::UncertaintyRules rules;
  const json* value = reader.member("uncertainty");
  if (value == nullptr) return rules;
  InputReader members{*value, "/uncertainty"};
  read_error_model(members, rules);
  if (const auto objective = members.text("objective")) {
    if (*objective == "mean") rules.objective = RobustObjective::mean;
    if (*objective == "quantile") rules.objective = RobustObjective::quantile;
    if (rules.objective == RobustObjective::none) {
      members.refuse("/uncertainty/objective",
                     "must be \"mean\" or \"quantile\", not \"" + *objective + "\"");
    }
  }
  if (const auto quantile = members.number("quantile", {0.01, 0.99})) {
    rules.quantile = *quantile;
    // What plans of older versions say of their inputs names it beside any objective, null included.
    if (!value->contains("objective"))
      members.refuse("/uncertainty/quantile",
                     "counts with the objective \"quantile\" only: ask for that, too");
  }
  rules.arrive_before = members.time("arrive_before");
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
  return rules;
}

json uncertainty_json(const planning::UncertaintyRules& rules) {
  const bool drawn = rules.drawn_members > 0;
  if (!drawn && rules.objective == RobustObjective::none && !rules.arrive_before) return nullptr;
  const auto objective = objective_name(rules.objective);
  json result{{"objective", objective ? json(*objective) : json()},
              {"quantile", rules.objective == RobustObjective::quantile ? json(rules.quantile) : json()},
              {"arrive_before", rules.arrive_before ? json(core::iso8601(*rules.arrive_before)) : json()}};
  if (!drawn) return result;
  result["members"] = rules.drawn_members;
  result["current_error_m_s"] = rules.error.standard_deviation.value;
  result["length_scale_m"] = rules.error.length_scale.value;
  result["time_scale_s"] = rules.error.time_scale.count();
  result["seed"] = rules.seed;
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

}  // namespace floeplan::codec
