#include "api/codec/documents/passage_document.hpp"

#include "api/codec/bytes/document_values.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

json passed_under_json(const std::vector<planning::PassedUnder>& passed) {
  json result = json::array();
  for (const planning::PassedUnder& under : passed) {
    result.push_back({{"iceberg", under.iceberg},
                      {"draft_m", under.keel.draft.value},
                      {"draft_from", under.keel.draft_is_stated ? "sighting" : "length"},
                      {"deepest_keel_m", under.keel.deepest.value},
                      {"upper_turn_m", under.keel.upper_turn.value},
                      {"clearance_m", (under.keel.upper_turn - under.keel.deepest).value},
                      {"from", core::iso8601(under.from)},
                      {"until", core::iso8601(under.until)}});
  }
  return result;
}

std::vector<planning::PassedUnder> parse_passed_under(const json& document) {
  std::vector<planning::PassedUnder> result;
  for (const json& object : document.at("passed_under")) {
    result.push_back({.iceberg = object.at("iceberg").get<std::string>(),
                      .keel = {.draft = {object.at("draft_m").get<double>()},
                               .draft_is_stated = object.at("draft_from") == "sighting",
                               .deepest = {object.at("deepest_keel_m").get<double>()},
                               .upper_turn = {object.at("upper_turn_m").get<double>()}},
                      .from = stored_time(object, "from"),
                      .until = stored_time(object, "until")});
  }
  return result;
}

json encounter_trade_json(const planning::Plan& plan) {
  if (!plan.encounter_trade) return nullptr;
  const planning::EncounterTrade& trade = *plan.encounter_trade;
  return {{"weight_s", trade.weight.count()},
          {"before",
           {{"travel_time_s", trade.time_before.count()}, {"iceberg_encounters", trade.encounters_before}}},
          {"after",
           {{"travel_time_s", plan.travel_time().count()},
            {"iceberg_encounters", plan.iceberg_encounters.value_or(0.0)}}}};
}

std::optional<planning::EncounterTrade> parse_encounter_trade(const json& document) {
  const json& trade = document.at("encounter_trade");
  if (trade.is_null()) return std::nullopt;
  const json& before = trade.at("before");
  return planning::EncounterTrade{.weight = core::Seconds{trade.at("weight_s").get<double>()},
                                  .time_before = core::Seconds{before.at("travel_time_s").get<double>()},
                                  .encounters_before = before.at("iceberg_encounters").get<double>()};
}

}  // namespace floeplan::codec
