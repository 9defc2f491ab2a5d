#include "api/codec/documents/departure_document.hpp"

#include <cmath>

#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

json departures_json(const std::vector<planning::DepartureOutcome>& outcomes) {
  json result = json::array();
  for (const planning::DepartureOutcome& outcome : outcomes) {
    json entry{{"departure", core::iso8601(outcome.departure)},
               {"arrival", nullptr},
               {"travel_time_s", nullptr},
               {"energy_j", nullptr},
               {"status", outcome.closed ? "infeasible" : "ok"},
               {"reason", nullptr},
               {"explanation", nullptr}};
    if (outcome.travel_time) {
      entry["arrival"] = core::iso8601(outcome.arrival());
      entry["travel_time_s"] = outcome.travel_time->count();
    }
    if (outcome.robust_cost) {
      const bool is_known = std::isfinite(*outcome.robust_cost);
      entry["robust_cost"] = is_known ? json(*outcome.robust_cost) : json();
      entry["members_without_way"] = outcome.members_closed;
    }
    if (outcome.energy) entry["energy_j"] = outcome.energy->value;
    if (outcome.closed) {
      entry["reason"] = planning::reason_name(outcome.closed->reason);
      entry["explanation"] = outcome.closed->explanation();
    }
    result.push_back(std::move(entry));
  }
  return result;
}

}  // namespace floeplan::codec
