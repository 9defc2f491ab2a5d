#include "api/codec/features/iceberg_feature.hpp"

#include "api/codec/features/line_geometry.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "engine/core/utc_text.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

nlohmann::json optional_metres(const std::optional<core::Metres>& length) {
  return length ? nlohmann::json(length->value) : nlohmann::json();
}

std::optional<core::Metres> metres_of(InputReader& reader, const std::string& key, double most) {
  const auto value = reader.number(key, {0.0, most});
  return value ? std::optional{core::Metres{*value}} : std::nullopt;
}

/// The position of a feature; a geometry other than a Point is a violation.
std::optional<geo::LonLat> read_point(const nlohmann::json& feature, core::Violations& violations) {
  static const nlohmann::json none = nlohmann::json::object();
  const nlohmann::json* geometry = feature.contains("geometry") ? &feature.at("geometry") : &none;
  if (!geometry->is_object() || geometry->value("type", nlohmann::json{}) != "Point") {
    violations.push_back(messages::fault<"wrong-shape">("/geometry", "a Point"));
    return std::nullopt;
  }
  InputReader reader{*geometry, "/geometry"};
  reader.require("coordinates", "[longitude, latitude] in degrees");
  const auto place = reader.place("coordinates");
  violations.insert(violations.end(), reader.violations().begin(), reader.violations().end());
  return place;
}

}  // namespace

nlohmann::json iceberg_feature(const repository::StoredSighting& sighting) {
  const auto& berg = sighting.iceberg;
  return {{"type", "Feature"},
          {"id", sighting.row},
          {"geometry", {{"type", "Point"}, {"coordinates", {berg.place.lon_deg, berg.place.lat_deg}}}},
          {"properties",
           {{"berg_id", berg.id},
            {"observed", core::iso8601(berg.observed)},
            {"size", ocean::size_name(berg.size)},
            {"length_m", optional_metres(berg.length)},
            {"safe_length_m", ocean::safe_length(berg).value},
            {"draft_m", optional_metres(berg.draft)},
            {"position_uncertainty_m", optional_metres(berg.position_uncertainty)},
            {"shape", berg.shape},
            {"method", berg.method},
            {"dataset_id", sighting.dataset.value}}}};
}

tl::expected<ocean::Iceberg, core::Violations> parse_iceberg_feature(const nlohmann::json& feature) {
  constexpr double longest_m = 400'000.0;  // B-15, the longest iceberg measured, was 295 km long
  constexpr double deepest_m = 1'000.0;
  constexpr double least_certain_m = 1e6;
  static const nlohmann::json none = nlohmann::json::object();
  core::Violations violations;
  const auto place = read_point(feature, violations);
  const bool has_properties = feature.contains("properties") && feature.at("properties").is_object();
  InputReader reader{has_properties ? feature.at("properties") : none, "/properties"};
  reader.require("berg_id", "the name of the berg, the same in each of its sightings");
  reader.require("observed", "when it was seen, ISO 8601 with its zone");

  ocean::Iceberg berg;
  berg.id = reader.text("berg_id").value_or("");
  berg.observed = reader.time("observed").value_or(core::UtcTime{});
  if (const auto name = reader.text("size")) {
    const auto size = ocean::parse_size(*name);
    if (!size)
      reader.refuse<"wrong-shape">(
          "/properties/size",
          "growler, bergy_bit, small, medium, large, very_large, unknown or radar_target");
    berg.size = size.value_or(ocean::IcebergSize::unknown);
  }
  berg.length = metres_of(reader, "length_m", longest_m);
  berg.draft = metres_of(reader, "draft_m", deepest_m);
  berg.position_uncertainty = metres_of(reader, "position_uncertainty_m", least_certain_m);
  berg.shape = reader.text("shape").value_or("");
  berg.method = reader.text("method").value_or("");
  violations.insert(violations.end(), reader.violations().begin(), reader.violations().end());
  if (!violations.empty()) return tl::unexpected(std::move(violations));
  berg.place = *place;
  return berg;
}

nlohmann::json iceberg_track_feature(const repository::IcebergTrack& track) {
  std::vector<geo::LonLat> way;
  nlohmann::json times = nlohmann::json::array();
  for (const auto& fix : track.fixes) {
    way.push_back(fix.place);
    times.push_back(core::iso8601(fix.time));
  }
  return {{"type", "Feature"},
          {"id", track.first_row},
          {"geometry", line_geometry(way)},
          {"properties",
           {{"berg_id", track.berg_id},
            {"from", core::iso8601(track.fixes.front().time)},
            {"until", core::iso8601(track.fixes.back().time)},
            {"sightings", track.fixes.size()},
            {"times", std::move(times)},
            {"dataset_id", track.dataset.value}}}};
}

}  // namespace floeplan::codec
