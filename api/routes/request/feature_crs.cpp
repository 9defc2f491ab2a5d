#include "api/routes/request/feature_crs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

constexpr double mercator_radius_m = 6'378'137.0;
constexpr double radians_per_degree = std::numbers::pi / 180.0;

void express_positions(nlohmann::json& coordinates, FeatureCrs crs) {
  if (!coordinates.is_array() || coordinates.empty()) return;
  if (!coordinates.front().is_number()) {
    for (auto& member : coordinates) express_positions(member, crs);
    return;
  }
  const auto [first, second] =
      from_lon_lat({coordinates.at(0).get<double>(), coordinates.at(1).get<double>()}, crs);
  coordinates[0] = first;
  coordinates[1] = second;
}

}  // namespace

const std::vector<std::string>& crs_uris() {
  static const std::vector<std::string> uris{"http://www.opengis.net/def/crs/OGC/1.3/CRS84",
                                             "http://www.opengis.net/def/crs/EPSG/0/4326",
                                             "http://www.opengis.net/def/crs/EPSG/0/3857"};
  return uris;
}

std::optional<FeatureCrs> parse_crs(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, FeatureCrs>, 5> short_names{
      {{"CRS84", FeatureCrs::crs84},
       {"CRS:84", FeatureCrs::crs84},
       {"OGC:CRS84", FeatureCrs::crs84},
       {"EPSG:4326", FeatureCrs::epsg4326},
       {"EPSG:3857", FeatureCrs::web_mercator}}};
  for (const auto& [short_name, crs] : short_names)
    if (name == short_name) return crs;
  const auto& uris = crs_uris();
  const auto found = std::ranges::find(uris, name);
  if (found == uris.end()) return std::nullopt;
  return static_cast<FeatureCrs>(found - uris.begin());
}

const std::string& uri_of(FeatureCrs crs) { return crs_uris().at(static_cast<std::size_t>(crs)); }

Coordinates from_lon_lat(geo::LonLat place, FeatureCrs crs) {
  switch (crs) {
    case FeatureCrs::crs84: return {place.lon_deg, place.lat_deg};
    case FeatureCrs::epsg4326: return {place.lat_deg, place.lon_deg};
    case FeatureCrs::web_mercator:
      return {mercator_radius_m * place.lon_deg * radians_per_degree,
              mercator_radius_m *
                  std::log(std::tan(std::numbers::pi / 4.0 + place.lat_deg * radians_per_degree / 2.0))};
  }
  throw std::logic_error{"FeatureCrs without coordinates"};
}

geo::LonLat to_lon_lat(Coordinates coordinates, FeatureCrs crs) {
  switch (crs) {
    case FeatureCrs::crs84: return {coordinates.first, coordinates.second};
    case FeatureCrs::epsg4326: return {coordinates.second, coordinates.first};
    case FeatureCrs::web_mercator:
      return {coordinates.first / mercator_radius_m / radians_per_degree,
              (2.0 * std::atan(std::exp(coordinates.second / mercator_radius_m)) - std::numbers::pi / 2.0) /
                  radians_per_degree};
  }
  throw std::logic_error{"FeatureCrs without coordinates"};
}

void express_in(nlohmann::json& geometry, FeatureCrs crs) {
  if (crs == FeatureCrs::crs84 || geometry.is_null()) return;
  express_positions(geometry.at("coordinates"), crs);
}

}  // namespace floeplan::routes
