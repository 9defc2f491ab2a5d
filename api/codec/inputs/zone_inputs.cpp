#include "api/codec/inputs/zone_inputs.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "api/codec/bytes/document_values.hpp"
#include "api/fields/limits.hpp"
#include "engine/core/utc_text.hpp"
#include "engine/geo/ring_crossing.hpp"
#include "engine/geo/ring_turns.hpp"
#include "engine/ocean/zone_words.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr std::size_t max_features = 1'000;
// limited because every leg is tested against the corners of zones with a period
constexpr std::size_t max_corners = 100'000;

/// Adds corners to edges that lead around the whole Earth along a parallel or a pole, as from -180 to 180,
/// because their two ends are the same position. `written`: the positions with their longitudes as written
geo::Ring with_edges_round_the_earth(const json& written, const std::vector<geo::LonLat>& places) {
  constexpr int parts = 6;
  geo::Ring ring{places.front()};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double from_deg = written[i - 1][0].get<double>();
    const double way_deg = written[i][0].get<double>() - from_deg;
    const bool leads_round = std::abs(way_deg) == 360.0 && places[i - 1].lat_deg == places[i].lat_deg;
    for (int part = 1; leads_round && part < parts; ++part) {
      const double share = static_cast<double>(part) / parts;
      ring.push_back({geo::wrap_longitude(from_deg + share * way_deg), places[i].lat_deg});
    }
    ring.push_back(places[i]);
  }
  return ring;
}

/// The corners of a closed ring, without repeating the first.
std::optional<geo::Ring> read_ring(InputReader& reader, const json& value, const std::string& pointer) {
  auto places = reader.places(value, pointer, 4, max_corners);
  if (!places) return std::nullopt;
  if (places->front() != places->back()) {
    reader.refuse<"ring-open">(pointer);
    return std::nullopt;
  }
  geo::Ring ring = with_edges_round_the_earth(value, *places);
  ring.pop_back();
  if (const std::string doubt = geo::doubt_in_turns({.outer = ring, .holes = {}}); !doubt.empty()) {
    reader.refuse<"ring-doubtful">(pointer, doubt);
    return std::nullopt;
  }
  const geo::RingCrossing crossing = geo::find_crossing(ring);
  if (crossing.place) {
    reader.refuse<"ring-crosses-itself">(pointer, json::array({document_degrees(crossing.place->lon_deg),
                                                               document_degrees(crossing.place->lat_deg)})
                                                      .dump());
  } else if (!crossing.is_looked_through) {
    reader.refuse<"ring-too-complex">(pointer);
  }
  return ring;
}

/// Refuses holes that have no corner and no middle of an edge inside the outline: the user probably meant
/// separate areas, which would be ignored. `pointer`: JSON pointer of the polygon's rings
void refuse_holes_outside(InputReader& reader, const geo::Polygon& polygon, const std::string& pointer) {
  std::vector<geo::LonLat> places;
  for (const geo::Ring& hole : polygon.holes) {
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const geo::LonLat a = hole[i];
      const geo::LonLat b = hole[(i + 1) % hole.size()];
      const double middle_deg = a.lon_deg + 0.5 * geo::longitude_difference(a.lon_deg, b.lon_deg);
      places.push_back(a);
      places.push_back({geo::wrap_longitude(middle_deg), 0.5 * (a.lat_deg + b.lat_deg)});
    }
  }
  const geo::Polygon outline{.outer = polygon.outer, .holes = {}};
  const std::vector<bool> is_inside = geo::contained_in_any(std::span{&outline, 1}, places);
  auto of_hole = is_inside.begin();
  for (std::size_t i = 0; i < polygon.holes.size() && !reader.is_full(); ++i) {
    const auto end = of_hole + static_cast<std::ptrdiff_t>(2 * polygon.holes[i].size());
    if (std::find(of_hole, end, true) == end)
      reader.refuse<"hole-outside">(pointer + "/" + std::to_string(i + 1));
    of_hole = end;
  }
}

std::optional<geo::Polygon> read_polygon(InputReader& reader, const json& rings, const std::string& pointer) {
  if (!rings.is_array() || rings.empty()) {
    reader.refuse<"wrong-shape">(pointer, "an array of rings, the outer one first");
    return std::nullopt;
  }
  geo::Polygon polygon;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    auto ring = read_ring(reader, rings[i], pointer + "/" + std::to_string(i));
    if (!ring) return std::nullopt;
    if (i == 0) {
      polygon.outer = std::move(*ring);
    } else {
      polygon.holes.push_back(std::move(*ring));
    }
  }
  refuse_holes_outside(reader, polygon, pointer);
  return polygon;
}

std::vector<geo::Polygon> read_geometry(InputReader& reader, const json& feature,
                                        const std::string& pointer) {
  const json* geometry = feature.contains("geometry") ? &feature.at("geometry") : nullptr;
  const std::string here = pointer + "/geometry";
  const bool known = geometry != nullptr && geometry->is_object() && geometry->contains("coordinates");
  const std::string type = known ? geometry->value("type", json{}).dump() : "";
  if (type != "\"Polygon\"" && type != "\"MultiPolygon\"") {
    reader.refuse<"wrong-shape">(here, "a GeoJSON Polygon or MultiPolygon");
    return {};
  }
  const json& coordinates = geometry->at("coordinates");
  std::vector<geo::Polygon> polygons;
  const auto add = [&](const json& rings, const std::string& at) {
    if (auto polygon = read_polygon(reader, rings, at)) polygons.push_back(std::move(*polygon));
  };
  if (type == "\"Polygon\"") {
    add(coordinates, here + "/coordinates");
  } else if (!coordinates.is_array() || coordinates.empty()) {
    reader.refuse<"wrong-shape">(here + "/coordinates", "an array of polygons");
  } else {
    for (std::size_t i = 0; i < coordinates.size() && !reader.is_full(); ++i) {
      add(coordinates[i], here + "/coordinates/" + std::to_string(i));
    }
  }
  return polygons;
}

/// The property that an attribute with this name probably means; nullopt if it means none.
std::optional<std::string> property_meant_by(std::string_view name) {
  switch (ocean::meaning_of_attribute(name)) {
    using enum ocean::AttributeMeaning;
    case kind: return "\"kind\"";
    case from: return "\"from\"";
    case until: return "\"until\"";
    case period: return "\"from\" and \"until\"";
    case top: return "\"top_m\"";
    case bottom: return "\"bottom_m\"";
    case depths: return "\"top_m\" and \"bottom_m\"";
    default: return std::nullopt;
  }
}

/// Refuses properties that mean a zone's property but have another name: with "bottom" instead of "bottom_m",
/// the rule would apply at all depths.
void refuse_near_names(InputReader& members, const json& properties) {
  constexpr auto right_names =
      std::to_array<std::string_view>({"kind", "from", "until", "top_m", "bottom_m"});
  if (!properties.is_object()) return;
  for (const auto& [name, value] : properties.items()) {
    if (members.is_full()) return;
    if (value.is_null() || value.is_boolean() || std::ranges::count(right_names, name) > 0) continue;
    if (const auto meant = property_meant_by(name)) members.refuse_member<"near-name">(name, *meant);
  }
}

/// Reads everything of a zone except its area.
ocean::Zone read_properties(InputReader& reader, const json& feature, const std::string& pointer) {
  static const json none = json::object();
  const json* properties = feature.contains("properties") ? &feature.at("properties") : &none;
  InputReader members{properties->is_null() ? none : *properties, pointer + "/properties"};
  refuse_near_names(members, *properties);
  ocean::Zone zone;
  const std::string kinds = "\"no_go\" (keep out) or \"stay_in\" (keep inside)";
  members.require("kind", kinds);
  if (const auto kind = members.text("kind")) {
    const auto known = ocean::parse_zone_kind(*kind);
    if (!known) members.refuse_member<"wrong-shape-found">("kind", kinds, "\"" + *kind + "\"");
    zone.kind = known.value_or(ocean::ZoneKind::no_go);
  }
  zone.name = members.text("name").value_or("");
  zone.from = members.time("from");
  zone.until = members.time("until");
  if (zone.until &&
      properties->at("until").get_ref<const std::string&>().size() == std::string_view{"2026-11-20"}.size())
    *zone.until += std::chrono::days{1};  // a day without a time means its end, as in zone files
  if (const auto top = members.number("top_m", {0.0, fields::deepest_m})) zone.top = {*top};
  if (const auto bottom = members.number("bottom_m", {0.0, fields::deepest_m})) zone.bottom = {*bottom};
  if (zone.from && zone.until && *zone.until < *zone.from) {
    members.refuse_member<"ends-before-it-begins">("until");
  }
  if (zone.bottom < zone.top) {
    members.refuse_member<"bottom-above-top">("bottom_m");
  }
  reader.refuse_all("", members.violations());
  return zone;
}

std::size_t corners_of(const geo::Polygon& polygon) {
  std::size_t corners = polygon.outer.size();
  for (const geo::Ring& hole : polygon.holes) corners += hole.size();
  return corners;
}

json ring_json(const geo::Ring& ring) {
  json places = json::array();
  for (const geo::LonLat place : ring) places.push_back(json::array({place.lon_deg, place.lat_deg}));
  places.push_back(json::array({ring.front().lon_deg, ring.front().lat_deg}));
  return places;
}

json polygon_json(const geo::Polygon& polygon) {
  json rings = json::array({ring_json(polygon.outer)});
  for (const geo::Ring& hole : polygon.holes) rings.push_back(ring_json(hole));
  return rings;
}

json geometry_json(std::span<const ocean::Zone> parts) {
  if (parts.size() == 1) return {{"type", "Polygon"}, {"coordinates", polygon_json(parts.front().area)}};
  json polygons = json::array();
  for (const ocean::Zone& part : parts) polygons.push_back(polygon_json(part.area));
  return {{"type", "MultiPolygon"}, {"coordinates", std::move(polygons)}};
}

/// One feature for zones that differ only in their area.
json feature_json(std::span<const ocean::Zone> parts) {
  const ocean::Zone& zone = parts.front();
  return {{"type", "Feature"},
          {"geometry", geometry_json(parts)},
          {"properties",
           {{"kind", ocean::zone_kind_name(zone.kind)},
            {"name", zone.name},
            {"from", zone.from ? json(core::iso8601(*zone.from)) : json()},
            {"until", zone.until ? json(core::iso8601(*zone.until)) : json()},
            {"top_m", zone.top.value},
            {"bottom_m", std::isfinite(zone.bottom.value) ? json(zone.bottom.value) : json()}}}};
}

}  // namespace

std::vector<ocean::Zone> read_areas(InputReader& reader) {
  const json* areas = reader.member("areas");
  if (areas == nullptr) return {};
  const json type = areas->is_object() ? areas->value("type", json{}) : json{};
  const bool collection =
      type == "FeatureCollection" && areas->contains("features") && areas->at("features").is_array();
  if (!collection && type != "Feature") {
    reader.refuse<"wrong-shape-found">("/areas", "a GeoJSON FeatureCollection of polygons", shown(*areas));
    return {};
  }
  const std::size_t features = collection ? areas->at("features").size() : 1;
  if (features > max_features) {
    reader.refuse<"too-many">("/areas", max_features, "features", std::to_string(features));
    return {};
  }
  std::vector<ocean::Zone> zones;
  std::size_t corners = 0;
  for (std::size_t i = 0; i < features && !reader.is_full(); ++i) {
    const json& feature = collection ? areas->at("features")[i] : *areas;
    const std::string pointer = collection ? "/areas/features/" + std::to_string(i) : "/areas";
    if (!feature.is_object()) {
      reader.refuse<"wrong-shape-found">(pointer, "a GeoJSON Feature", shown(feature));
      continue;
    }
    ocean::Zone zone = read_properties(reader, feature, pointer);
    zone.feature = i;
    for (geo::Polygon& polygon : read_geometry(reader, feature, pointer)) {
      corners += corners_of(polygon);
      zone.area = std::move(polygon);
      zones.push_back(zone);
    }
  }
  if (corners > max_corners) {
    reader.refuse<"too-many-corners">("/areas", max_corners, corners);
  }
  return zones;
}

json areas_json(const std::vector<ocean::Zone>& zones) {
  json features = json::array();
  for (std::span<const ocean::Zone> left{zones}; !left.empty();) {
    const std::size_t parts = ocean::parts_of_first(left);
    features.push_back(feature_json(left.first(parts)));
    left = left.subspan(parts);
  }
  return {{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

}  // namespace floeplan::codec
