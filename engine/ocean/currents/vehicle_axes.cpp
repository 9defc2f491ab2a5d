#include "engine/ocean/currents/vehicle_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "engine/geo/magnetic_field.hpp"

namespace floeplan::ocean {
namespace {

constexpr std::array source_names{
    std::pair{VariationSource::log_axes, std::string_view{"x_utm_to_lmc"}},
    std::pair{VariationSource::log_variation, std::string_view{"m_gps_mag_var"}},
    std::pair{VariationSource::magnetic_model, std::string_view{"world-magnetic-model"}}};

/// Tolerance for the matrix in a log, which has single precision.
constexpr double rounding_of_matrix = 1e-3;
/// Axes that differ by a smaller angle are the same.
constexpr double same_turn_rad = 1e-5;
/// The receiver's table of variations is coarse and old. A larger difference from the model is a fault.
constexpr double usual_difference_deg = 3.0;

/// The magnetic variation in a rotation matrix; empty if the matrix is not a rotation, for example before it
/// is set.
std::optional<double> turn_of(std::optional<double> cosine, std::optional<double> sine) {
  if (!cosine || !sine || !(std::abs(std::hypot(*cosine, *sine) - 1.0) < rounding_of_matrix))
    return std::nullopt;
  return std::atan2(*sine, *cosine);
}

bool is_angle(double angle_rad) { return std::abs(angle_rad) <= std::numbers::pi; }

/// Whether the place is logged: a vehicle without a fix so far logs zeros.
bool is_told(const std::optional<geo::LonLat>& place) {
  return place && geo::is_valid(*place) && *place != geo::LonLat{0.0, 0.0};
}

bool is_zone(double number) { return number >= 1.0 && number <= 60.0 && number == std::floor(number); }

double off_deg(double a_rad, double b_rad) {
  return std::abs(core::radians_to_degrees(std::remainder(a_rad - b_rad, 2.0 * std::numbers::pi)));
}

std::string tenths(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/// A mission leads at most this far from its start: a vehicle makes 25 km a day (0.3 m/s), and pilots start
/// another mission after about a week.
constexpr double reach_of_mission_m = 200'000.0;
constexpr double metres_per_degree = 111'195.0;  // of the equator, on a sphere of 6371 km

/// The zone next to the nearer edge of a zone that contains the place, and the distance along the parallel to
/// that edge.
std::pair<int, double> nearest_zone_beside(int zone, geo::LonLat place) {
  const double from_meridian_deg = geo::longitude_difference(6.0 * zone - 183.0, place.lon_deg);
  const double to_edge_deg = std::max(0.0, 3.0 - std::abs(from_meridian_deg));
  const int beside = (zone + (from_meridian_deg < 0.0 ? 58 : 0)) % 60 + 1;
  return {beside, to_edge_deg * metres_per_degree * std::cos(core::degrees_to_radians(place.lat_deg))};
}

/// Text such as "27.2 degrees west".
std::string degrees_west(double variation_rad) {
  const double deg = core::radians_to_degrees(variation_rad);
  return tenths(std::abs(deg)) + (deg < 0.0 ? " degrees east" : " degrees west");
}

}  // namespace

std::string_view source_name(VariationSource source) {
  return std::ranges::find(source_names, source, [](const auto& each) { return each.first; })->second;
}

std::optional<VariationSource> parse_variation_source(std::string_view name) {
  const auto found = std::ranges::find(source_names, name, [](const auto& each) { return each.second; });
  return found == source_names.end() ? std::nullopt : std::optional{found->first};
}

std::string words_of(const VehicleAxes& known) {
  const std::string turned = "UTM zone " + std::to_string(known.axes.utm_zone()) + ", magnetic variation " +
                             degrees_west(known.axes.variation_west().value);
  switch (known.source) {
    case VariationSource::log_axes: return turned + " by the log's x_utm_to_lmc";
    case VariationSource::log_variation: return turned + " by the log's m_gps_mag_var";
    case VariationSource::magnetic_model: return turned + " by the World Magnetic Model";
  }
  return turned;
}

std::size_t LoggedAxes::note(const AxesRow& row) {
  const auto turn = turn_of(row.cosine, row.sine);
  const auto& before = missions_.back().turn_rad;
  if (turn && before && std::abs(*turn - *before) > same_turn_rad) missions_.emplace_back();
  Mission& mission = missions_.back();
  if (!std::exchange(begun_, true)) mission.segment = row.segment;
  if (turn && !mission.turn_rad) mission.turn_rad = turn;
  if (row.variation_rad && !is_angle(*row.variation_rad)) mission.impossible_variation = row.variation_rad;
  if (row.variation_rad && is_angle(*row.variation_rad) && mission.variation_rad.value_or(0.0) == 0.0)
    mission.variation_rad = row.variation_rad;
  if (row.utm_zone && is_zone(*row.utm_zone) && !mission.utm_zone)
    mission.utm_zone = static_cast<int>(*row.utm_zone);
  if (!mission.fix && is_told(row.fix)) {
    mission.fix = row.fix;
    if (row.time) mission.began = row.time;
  }
  if (!mission.place && is_told(row.place)) mission.place = row.place;
  if (!mission.began) mission.began = row.time;
  return missions_.size() - 1;
}

std::optional<geo::LonLat> LoggedAxes::origin(std::size_t number) const {
  const auto of = [](const Mission& mission) { return mission.fix ? mission.fix : mission.place; };
  if (const auto own = of(missions_.at(number))) return own;
  for (std::size_t i = 0; i < missions_.size(); ++i)  // the following missions, then those before
    if (const auto other = of(missions_[(number + i) % missions_.size()])) return other;
  return std::nullopt;
}

std::optional<VehicleAxes> LoggedAxes::axes(std::size_t number) const {
  const Mission& mission = missions_.at(number);
  const auto at = origin(number);
  if (!mission.utm_zone && !at) return std::nullopt;
  const int zone = mission.utm_zone ? *mission.utm_zone : geo::utm_zone_of(*at);
  if (mission.turn_rad) return VehicleAxes{{zone, {*mission.turn_rad}}, VariationSource::log_axes};
  if (mission.variation_rad)
    return VehicleAxes{{zone, {*mission.variation_rad}}, VariationSource::log_variation};
  if (!at || !mission.began) return std::nullopt;
  const auto declination = geo::declination_at(*at, *mission.began);
  if (!declination) return std::nullopt;
  return VehicleAxes{{zone, {-core::degrees_to_radians(declination->east_deg)}},
                     VariationSource::magnetic_model};
}

std::vector<std::string> LoggedAxes::doubts(std::size_t number) const {
  std::vector<std::string> doubts;
  const auto known = axes(number);
  const auto at = origin(number);
  if (!known || !at) return doubts;
  const Mission& mission = missions_.at(number);
  const auto model = mission.began ? geo::declination_at(*at, *mission.began) : std::nullopt;
  const double variation_rad = known->axes.variation_west().value;
  if (model && known->source != VariationSource::magnetic_model) {
    const double by_model_rad = -core::degrees_to_radians(model->east_deg);
    if (off_deg(variation_rad, by_model_rad) > std::max(usual_difference_deg, 3.0 * model->sigma_deg))
      doubts.push_back("the log's magnetic variation is " + degrees_west(variation_rad) +
                       ", that of the World Magnetic Model " + degrees_west(by_model_rad) +
                       "; the vehicle reckons by the log's, so its currents and headings are doubtful; "
                       "check its variation");
  }
  if (model && known->source == VariationSource::magnetic_model)
    doubts.push_back(
        (mission.impossible_variation
             ? "the log has no x_utm_to_lmc_00 and _01, and its m_gps_mag_var of " +
                   tenths(*mission.impossible_variation) +
                   " is impossible in radians, in which a Slocum logs it, and was not used"
             : std::string{"the log has neither x_utm_to_lmc_00 and _01 nor m_gps_mag_var"}) +
        "; the model's variation has a "
        "standard deviation of " +
        tenths(model->sigma_deg) + " degrees, and the vehicle may have used another; " +
        (mission.impossible_variation ? "convert m_gps_mag_var to radians" : "log m_gps_mag_var") +
        " to be sure");
  const int standard = geo::standard_utm_zone_of(*at);
  if (!mission.utm_zone && standard >= 1 && standard != known->axes.utm_zone()) {
    const geo::LocalMissionAxes other{standard, known->axes.variation_west()};
    const double turn_deg = off_deg(other.turn_at(*at).value, known->axes.turn_at(*at).value);
    doubts.push_back("the log does not name the zone of its grid (x_lmc_utm_zone_digit); zone " +
                     std::to_string(known->axes.utm_zone()) + " was taken; if the vehicle uses zone " +
                     std::to_string(standard) + ", the wider one of Norway and Svalbard, the currents lie " +
                     tenths(turn_deg) + " degrees off; log the zone to be sure");
  }
  const auto [beside, edge_m] = nearest_zone_beside(known->axes.utm_zone(), *at);
  if (!mission.utm_zone && mission.segment > 0 && edge_m <= reach_of_mission_m) {
    const geo::LocalMissionAxes other{beside, known->axes.variation_west()};
    const double turn_deg = off_deg(other.turn_at(*at).value, known->axes.turn_at(*at).value);
    doubts.push_back("the log begins with segment " + std::to_string(mission.segment) +
                     " of its mission and does not name the zone of its grid (x_lmc_utm_zone_digit), which "
                     "the vehicle keeps from the start of the mission; zone " +
                     std::to_string(known->axes.utm_zone()) + ", of the first fix, was taken; zone " +
                     std::to_string(beside) + " is " + tenths(edge_m / 1000.0) +
                     " km away, and if the mission began there, the currents lie " + tenths(turn_deg) +
                     " degrees off; give segment 0 in the same command, or log the zone");
  }
  return doubts;
}

}  // namespace floeplan::ocean
