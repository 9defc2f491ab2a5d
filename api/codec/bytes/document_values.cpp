#include "api/codec/bytes/document_values.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "engine/core/shown_text.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/core/violation_list.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/sentence.hpp"
#include "engine/messages/store_messages.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

namespace {

json values_json(const std::vector<core::NamedValue>& given) {
  json values = json::object();
  for (const auto& [name, value] : given) std::visit([&](const auto& held) { values[name] = held; }, value);
  return values;
}

json told_json(const messages::Message& message) {
  return {{"code", message.code},
          {"rank", messages::rank_name(message.rank)},
          {"place", message.place ? json{{"lon", document_degrees(message.place->lon_deg)},
                                         {"lat", document_degrees(message.place->lat_deg)}}
                                  : json()},
          {"values", values_json(message.values)},
          {"text", messages::whole_text(message)}};
}

messages::Message stored_message(const json& document) {
  messages::Message message{
      .code = document.at("code").get<std::string>(),
      .rank = messages::parse_rank(document.at("rank").get<std::string>()).value_or(messages::Rank::caution),
      .text = document.at("text").get<std::string>()};
  if (const json& place = document.at("place"); !place.is_null())
    message.place = geo::LonLat{place.at("lon").get<double>(), place.at("lat").get<double>()};
  for (const auto& [name, value] : document.at("values").items()) {
    if (value.is_number_integer()) {
      message.values.push_back({name, value.get<std::int64_t>()});
    } else if (value.is_number()) {
      message.values.push_back({name, value.get<double>()});
    } else if (value.is_string()) {  // null: a number that was not finite
      message.values.push_back({name, value.get<std::string>()});
    }
  }
  return message;
}

}  // namespace

std::string waypoint_label(std::size_t index) { return index == 0 ? "S" : std::to_string(index); }

double document_degrees(double degrees) { return std::round(degrees * 1e7) / 1e7; }

json optional_time(const std::optional<core::UtcTime>& time) {
  return time ? json(core::iso8601(*time)) : json();
}

core::UtcTime stored_time(const json& object, const char* key) {
  const auto time = core::parse_iso8601(object.at(key).get<std::string>());
  if (!time)
    throw std::runtime_error{
        messages::store_text<"stored-plan-unreadable">("it has no valid time " + std::string{key})};
  return *time;
}

json messages_json(const std::vector<messages::Message>& messages) {
  json told = json::array();
  for (const messages::Message& message : messages) told.push_back(told_json(message));
  return told;
}

json errors_json(const core::Violations& violations) {
  const auto shown = [](const std::string& text) { return core::excerpt(core::without_secrets(text)); };
  json errors = json::array();
  for (core::Violation& violation : core::shortened(violations)) {
    json error{{"pointer", shown(violation.field)}, {"detail", shown(violation.rule)}};
    for (auto& [name, value] : violation.values)
      if (auto* words = std::get_if<std::string>(&value)) *words = shown(*words);
    if (!violation.code.empty()) {
      error["code"] = violation.code;
      error["values"] = values_json(violation.values);
    }
    errors.push_back(std::move(error));
  }
  return errors;
}

void tell(json& document, std::vector<messages::Message> messages) {
  const std::vector<messages::Message> ordered = messages::by_rank(std::move(messages));
  document["messages"] = messages_json(ordered);
  document["dangers"] = messages::dangers_among(ordered);
  document["warnings"] = messages::sentences(ordered);
}

std::vector<messages::Message> stored_messages(const json& document) {
  std::vector<messages::Message> told;
  if (const auto stored = document.find("messages"); stored != document.end()) {
    for (const json& message : *stored) told.push_back(stored_message(message));
    return told;
  }
  for (const auto& sentence : document.at("warnings").get<std::vector<std::string>>()) {
    const std::string text = messages::without_mark(sentence);
    told.push_back(messages::is_danger(sentence) ? messages::plan_message<"earlier-danger">(text)
                                                 : messages::plan_message<"earlier-warning">(text));
  }
  return told;
}

}  // namespace floeplan::codec
