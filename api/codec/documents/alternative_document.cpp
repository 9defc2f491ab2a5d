#include "api/codec/documents/alternative_document.hpp"

#include "api/codec/bytes/document_values.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

nlohmann::json alternative_json(const planning::Alternative& alternative, const nlohmann::json& document) {
  nlohmann::json entry{{"message", messages_json({alternative.reason}).front()}};
  for (const char* name : {"plan_id", "name", "arrival", "travel_time_s", "distance_m", "energy_j"})
    entry[name] = document.at(name);
  return entry;
}

}  // namespace floeplan::codec
