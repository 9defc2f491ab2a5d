#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "api/codec/bytes/foreign_members.hpp"
#include "api/codec/bytes/json_text.hpp"
#include "api/codec/route_files/route_formats.hpp"
#include "engine/geo/geodesic.hpp"
#include "engine/mission/document/line_words.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

const json* array_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? &*found : nullptr;
}

/// The PlanSpecification: the message itself, or the argument of a PlanDB or PlanControl.
const json* plan_in(const json& message) {
  if (!message.is_object()) return nullptr;
  if (text_at(message, "abbrev") == "PlanSpecification") return &message;
  const auto inner = message.find("arg");
  return inner != message.end() && inner->is_object() && text_at(*inner, "abbrev") == "PlanSpecification"
             ? &*inner
             : nullptr;
}

/// The position of a maneuver, in radians; nullopt if the numbers are out of range, for instance degrees.
std::optional<geo::LonLat> place_in(const json& maneuver) {
  const auto lat = number_at(maneuver, "lat");
  const auto lon = number_at(maneuver, "lon");
  if (!lat || !lon || std::abs(*lat) > std::numbers::pi / 2.0 || std::abs(*lon) > std::numbers::pi)
    return std::nullopt;
  return geo::LonLat{core::radians_to_degrees(*lon), core::radians_to_degrees(*lat)};
}

/// Whether a maneuver covers an area in a pattern. The vehicle computes its positions, so they are unknown
/// here.
bool is_pattern(const std::string& kind) {
  return kind == "Rows" || kind == "RowsCoverage" || kind == "CoverArea";
}

/// Adds the positions of a maneuver; `here` names it in messages. Returns its fault, or nullopt.
std::optional<core::Violation> add_places(const json& maneuver, const std::string& here,
                                          std::vector<geo::LonLat>& places) {
  const std::string kind = text_at(maneuver, "abbrev");
  if (is_pattern(kind)) return messages::fault<"maneuver-pattern">(here, kind);
  const auto reference = place_in(maneuver);
  if (!reference) return messages::fault<"maneuver-without-place">(here);
  constexpr core::Metres same_place{1.0};
  const bool is_there =
      !places.empty() && geo::geodesic_between(places.back(), *reference).length <= same_place;
  if (kind == "StationKeeping" && is_there) return std::nullopt;
  const json* points = array_at(maneuver, "points");
  if (points == nullptr) {
    places.push_back(*reference);
    return std::nullopt;
  }
  for (const json& point : *points) {
    const auto north = point.is_object() ? number_at(point, "x") : std::nullopt;
    const auto east = point.is_object() ? number_at(point, "y") : std::nullopt;
    if (!north || !east || std::hypot(*north, *east) > 1e6)
      return messages::fault<"maneuver-without-metres">(here);
    places.push_back(geo::geodesic_destination(*reference, geo::Bearing::towards(*east, *north),
                                               core::Metres{std::hypot(*north, *east)}));
  }
  return std::nullopt;
}

/// For each maneuver those that may follow it. Conditions of the transitions are ignored.
std::map<std::string, std::set<std::string>> successors(const json& plan) {
  std::map<std::string, std::set<std::string>> next;
  const json* transitions = array_at(plan, "transitions");
  if (transitions == nullptr) return next;
  for (const json& transition : *transitions) {
    if (!transition.is_object()) continue;
    std::string sources = text_at(transition, "source_man");
    for (char& c : sources) c = c == ',' ? ' ' : c;
    const std::string to = text_at(transition, "dest_man");
    if (to == "done" || to == "error") continue;
    for (const std::string_view source : mission::words_of(sources)) next[std::string{source}].insert(to);
  }
  return next;
}

tl::expected<NamedRoute, core::Violations> route_in(const json& plan) {
  std::map<std::string, const json*> maneuvers;
  const json* listed = array_at(plan, "maneuvers");
  static const json none = json::array();
  for (const json& maneuver : listed == nullptr ? none : *listed) {
    if (maneuver.is_object() && maneuver.contains("data") && maneuver["data"].is_object())
      maneuvers.emplace(text_at(maneuver, "maneuver_id"), &maneuver["data"]);
  }

  const auto next = successors(plan);
  std::vector<geo::LonLat> places;
  std::set<std::string> done;
  for (std::string id = text_at(plan, "start_man_id"); done.insert(id).second;) {
    const std::string here = "maneuver \"" + id + "\"";
    const auto maneuver = maneuvers.find(id);
    if (maneuver == maneuvers.end()) return route_fault<"maneuver-missing">(here);
    if (auto fault = add_places(*maneuver->second, here, places))
      return tl::unexpected(core::Violations{std::move(*fault)});
    if (places.size() > max_places) return route_fault<"too-many-places-in-route">("file", max_places);
    const auto following = next.find(id);
    if (following == next.end()) break;
    if (following->second.size() > 1)
      return route_fault<"maneuver-ambiguous">(here, *following->second.begin(), *following->second.rbegin());
    id = *following->second.begin();
  }
  return NamedRoute{text_at(plan, "plan_id"), {std::move(places)}};
}

}  // namespace

bool is_imc_plan(std::string_view bytes) {
  return bytes.substr(0, 4096).find("\"abbrev\"") != std::string_view::npos;
}

ReadRoutes read_imc(std::string_view bytes) {
  const auto document = parse_json(bytes);
  if (!document) return route_fault<"route-file-unreadable">("file", document.error());
  FileRoutes file;
  const json all = document->is_array() ? *document : json::array({*document});
  for (const json& message : all) {
    const json* plan = plan_in(message);
    if (plan == nullptr) return route_fault<"no-imc-plan">("file");
    auto route = route_in(*plan);
    if (!route) return tl::unexpected(std::move(route.error()));
    file.routes.push_back(std::move(*route));
  }
  return file;
}

}  // namespace floeplan::codec
