#include "api/codec/under_ice_inputs.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr NumberRange share{0.0, 1.0};
constexpr NumberRange thickness_m{0.0, 500.0};
constexpr NumberRange a_minute_to_a_year_s{60.0, 3.2e7};

json optional_seconds(const std::optional<core::Seconds>& time) {
  return time ? json(time->count()) : json();
}

void read_passing(InputReader& members, planning::UnderIceRules& rules) {
  if (const auto value = members.number("max_concentration_to_surface", share))
    rules.max_concentration_to_surface = *value;
  if (const auto value = members.number("margin_below_ice_m", thickness_m)) rules.margin_below_ice = {*value};
  if (const auto value = members.number("draft_if_unknown_m", thickness_m)) rules.draft_if_unknown = {*value};
  if (const auto value = members.number("max_time_without_surfacing_s", a_minute_to_a_year_s))
    rules.max_time_without_surfacing = core::Seconds{*value};
}

json passing_json(const planning::UnderIceRules& rules) {
  return {{"max_concentration_to_surface", rules.max_concentration_to_surface},
          {"margin_below_ice_m", rules.margin_below_ice.value},
          {"draft_if_unknown_m", rules.draft_if_unknown.value},
          {"max_time_without_surfacing_s", optional_seconds(rules.max_time_without_surfacing)}};
}

/// Reads the members of `under_ice` by read(members).
void read_members(InputReader& reader, const auto& read) {
  const json* object = reader.member("under_ice");
  if (object == nullptr) return;
  InputReader members{*object};
  read(members);
  members.refuse_unknown();
  reader.refuse_all("/under_ice", members.violations());
}

}  // namespace

void read_under_ice(InputReader& reader, planning::UnderIceRules& rules) {
  read_members(reader, [&](InputReader& members) {
    read_passing(members, rules);
    if (const auto value = members.number("surfacing_interval_s", a_minute_to_a_year_s))
      rules.surfacing_interval = core::Seconds{*value};
    if (const auto value = members.boolean("escape_plan")) rules.escape_plan = *value;
    if (const auto value = members.number("dead_reckoning_share", share)) rules.dead_reckoning_share = *value;
    if (const auto value = members.number("current_uncertainty_m_s", {0.0, 5.0}))
      rules.current_uncertainty = {*value};
  });
}

void write_under_ice(const planning::UnderIceRules& rules, json& inputs) {
  json& written = inputs["under_ice"] = passing_json(rules);
  written["surfacing_interval_s"] = optional_seconds(rules.surfacing_interval);
  written["escape_plan"] = rules.escape_plan;
  written["dead_reckoning_share"] = rules.dead_reckoning_share;
  written["current_uncertainty_m_s"] = rules.current_uncertainty.value;
}

void read_passing_under_ice(InputReader& reader, planning::UnderIceRules& rules) {
  read_members(reader, [&](InputReader& members) { read_passing(members, rules); });
}

void write_passing_under_ice(const planning::UnderIceRules& rules, json& inputs) {
  inputs["under_ice"] = passing_json(rules);
}

}  // namespace floeplan::codec
