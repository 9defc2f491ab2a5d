#include "api/codec/under_ice_inputs.hpp"

#include <nlohmann/json.hpp>

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr NumberRange share{0.0, 1.0};
constexpr NumberRange thickness_m{0.0, 500.0};
constexpr NumberRange a_minute_to_a_year_s{60.0, 3.2e7};

json optional_seconds(const std::optional<core::Seconds>& time) {
  return time ? json(time->count()) : json();
}

}  // namespace

void read_under_ice(InputReader& reader, planning::UnderIceRules& rules) {
  const json* object = reader.member("under_ice");
  if (object == nullptr) return;
  InputReader members{*object};
  if (const auto value = members.number("max_concentration_to_surface", share))
    rules.max_concentration_to_surface = *value;
  if (const auto value = members.number("margin_below_ice_m", thickness_m)) rules.margin_below_ice = {*value};
  if (const auto value = members.number("draft_if_unknown_m", thickness_m)) rules.draft_if_unknown = {*value};
  if (const auto value = members.number("max_time_without_surfacing_s", a_minute_to_a_year_s))
    rules.max_time_without_surfacing = core::Seconds{*value};
  if (const auto value = members.number("surfacing_interval_s", a_minute_to_a_year_s))
    rules.surfacing_interval = core::Seconds{*value};
  if (const auto value = members.boolean("escape_plan")) rules.escape_plan = *value;
  if (const auto value = members.number("dead_reckoning_share", share)) rules.dead_reckoning_share = *value;
  if (const auto value = members.number("current_uncertainty_m_s", {0.0, 5.0}))
    rules.current_uncertainty = {*value};
  members.refuse_unknown();
  for (const core::Violation& violation : members.violations())
    reader.refuse("/under_ice" + violation.field, violation.rule);
}

void write_under_ice(const planning::UnderIceRules& rules, json& inputs) {
  inputs["under_ice"] = {{"max_concentration_to_surface", rules.max_concentration_to_surface},
                         {"margin_below_ice_m", rules.margin_below_ice.value},
                         {"draft_if_unknown_m", rules.draft_if_unknown.value},
                         {"max_time_without_surfacing_s", optional_seconds(rules.max_time_without_surfacing)},
                         {"surfacing_interval_s", optional_seconds(rules.surfacing_interval)},
                         {"escape_plan", rules.escape_plan},
                         {"dead_reckoning_share", rules.dead_reckoning_share},
                         {"current_uncertainty_m_s", rules.current_uncertainty.value}};
}

}  // namespace floeplan::codec
