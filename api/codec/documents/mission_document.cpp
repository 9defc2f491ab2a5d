#include "api/codec/documents/mission_document.hpp"

#include <cstddef>
#include <map>
#include <stdexcept>

#include "engine/mission/document/document_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// Largest number of messages of one severity. Every line of a file can be wrong, and nobody reads more.
constexpr std::size_t most_messages = 200;

json settings_json(const std::vector<mission::Argument>& settings) {
  json result = json::array();
  for (const auto& setting : settings) {
    result.push_back({{"name", setting.name},
                      {"unit", setting.unit},
                      {"value", setting.value},
                      {"raw", setting.raw},
                      {"line", setting.line}});
  }
  return result;
}

json behaviors_json(const mission::Document& document) {
  json result = json::array();
  for (const auto& behavior : document.behaviors) {
    result.push_back(
        {{"name", behavior.name}, {"line", behavior.line}, {"b_args", settings_json(behavior.arguments)}});
  }
  return result;
}

json waypoints_json(const mission::Document& document) {
  json result = json::array();
  for (const auto& row : document.waypoints) {
    result.push_back({{"lon", row.place.lon_deg}, {"lat", row.place.lat_deg}, {"line", row.line}});
  }
  return result;
}

json bands_json(const mission::Document& document) {
  json result = json::array();
  for (const auto& band : document.bands) {
    result.push_back({{"depth_m", band.depth ? json(band.depth->value) : json()},
                      {"seconds", band.seconds},
                      {"sensors", band.sensors},
                      {"guidance_seconds", band.guidance_seconds},
                      {"line", band.line}});
  }
  return result;
}

std::string kind_name(mission::DocumentKind kind) {
  switch (kind) {
    case mission::DocumentKind::mission: return "mi";
    case mission::DocumentKind::arguments: return "ma";
    case mission::DocumentKind::targets: return "targets";
    case mission::DocumentKind::science: return "science";
    case mission::DocumentKind::cmdfile: return "cmdfile";
  }
  throw std::logic_error{"DocumentKind without a name"};
}

json message_json(const mission::Message& message) {
  return {{"line", message.line},
          {"severity", mission::severity_name(message.severity)},
          {"code", message.code},
          {"text", message.text}};
}

json messages_json(const mission::Messages& messages) {
  json result = json::array();
  std::map<mission::Severity, std::size_t> seen;
  for (const auto& message : messages) {
    const std::size_t count = ++seen[message.severity];
    if (count <= most_messages) result.push_back(message_json(message));
    if (count == most_messages + 1)
      result.push_back(message_json(
          {message.line, message.severity, "more_messages",
           "the " + mission::severity_name(message.severity) + "s from here on are not listed"}));
  }
  return result;
}

}  // namespace

json mission_document(const mission::Document& document, const std::string& file) {
  const bool arguments = document.kind == mission::DocumentKind::arguments;
  const bool one = arguments && !document.behaviors.empty();
  return {{"file", file},
          {"kind", kind_name(document.kind)},
          {"verdict", mission::verdict_name(document.verdict())},
          {"behavior", one ? json(document.behaviors.front().name) : json()},
          {"b_args", one ? settings_json(document.behaviors.front().arguments) : json::array()},
          {"sensors", settings_json(document.sensors)},
          {"behaviors", behaviors_json(document)},
          {"waypoints", waypoints_json(document)},
          {"bands", bands_json(document)},
          {"waypoints_declared", document.waypoints_declared ? json(*document.waypoints_declared) : json()},
          {"files_referenced", mission::files_referenced(document)},
          {"bytes", document.format.bytes},
          {"encoding", document.format.encoding},
          {"line_endings", document.format.line_endings},
          {"messages", messages_json(document.messages)}};
}

}  // namespace floeplan::codec
