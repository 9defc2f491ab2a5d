#include "api/codec/documents/alternative_document.hpp"

#include <array>
#include <cstdio>

#include "api/codec/bytes/document_values.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

nlohmann::json alternative_json(const planning::Alternative& alternative, const nlohmann::json& document) {
  nlohmann::json entry{{"message", messages_json({alternative.reason}).front()}};
  for (const char* name : {"plan_id", "name", "arrival", "travel_time_s", "distance_m", "energy_j"})
    entry[name] = document.at(name);
  return entry;
}

std::vector<std::string> alternative_lines(const nlohmann::json& plan_document) {
  std::vector<std::string> lines;
  for (const nlohmann::json& entry : plan_document.value("alternatives", nlohmann::json::array())) {
    std::array<char, 64> figures{};
    std::snprintf(figures.data(), figures.size(),
                  ", %.1f h, %.1f km: ", entry.at("travel_time_s").get<double>() / 3600.0,
                  entry.at("distance_m").get<double>() / 1000.0);
    lines.push_back(entry.at("name").get<std::string>() + " (" + entry.at("plan_id").get<std::string>() +
                    "), arrival " + entry.at("arrival").get<std::string>() + figures.data() +
                    entry.at("message").at("text").get<std::string>());
  }
  return lines;
}

}  // namespace floeplan::codec
