#include "api/codec/inputs/sensor_inputs.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "api/codec/reading/input_limits.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using simulation::AdcpSettings;
using simulation::AltimeterSettings;
using simulation::SonarSettings;
using simulation::SoundWater;

constexpr double degree = std::numbers::pi / 180.0;
constexpr int most_count = 1'000'000;

/// A numeric member, with the size of its unit in the unit of the setting.
template <class Settings>
struct Number {
  const char* key;
  double Settings::* member;
  double unit{1.0};
};

template <class Settings>
struct Count {
  const char* key;
  int Settings::* member;
};

constexpr Number<SonarSettings> sonar_numbers[] = {
    {"frequency_khz", &SonarSettings::frequency_khz},
    {"source_level_db", &SonarSettings::source_level_db},
    {"pulse_s", &SonarSettings::pulse_s},
    {"interval_s", &SonarSettings::interval_s},
    {"range_m", &SonarSettings::range_m},
    {"blind_m", &SonarSettings::blind_m},
    {"beam_step_deg", &SonarSettings::beam_step_rad, degree},
    {"row_step_deg", &SonarSettings::row_step_rad, degree},
    {"tilt_deg", &SonarSettings::tilt_rad, degree},
    {"receiver_noise_db", &SonarSettings::receiver_noise_db},
    {"false_alarms_per_ping", &SonarSettings::false_alarms_per_ping},
    {"ice_strength_db", &SonarSettings::ice_strength_db},
    {"sea_bed_strength_db", &SonarSettings::sea_bed_strength_db},
    {"volume_strength_db", &SonarSettings::volume_strength_db},
    {"sound_speed_error_share", &SonarSettings::sound_speed_error_share}};

constexpr Count<SonarSettings> sonar_counts[] = {
    {"beams", &SonarSettings::beams},
    {"rows", &SonarSettings::rows},
    {"most_returns_per_beam", &SonarSettings::most_returns_per_beam}};

constexpr Number<simulation::BeamPattern> beam_numbers[] = {
    {"beam_width_deg", &simulation::BeamPattern::width_rad, degree},
    {"beam_height_deg", &simulation::BeamPattern::height_rad, degree},
    {"side_lobes_db", &simulation::BeamPattern::side_lobes_db}};

constexpr Number<SoundWater> water_numbers[] = {{"temperature_deg_c", &SoundWater::temperature_deg_c},
                                                {"salinity_g_kg", &SoundWater::salinity_g_kg},
                                                {"ph", &SoundWater::ph},
                                                {"depth_m", &SoundWater::depth_m},
                                                {"speed_m_s", &SoundWater::speed_m_s},
                                                {"wind_m_s", &SoundWater::wind_m_s}};

constexpr Number<AltimeterSettings> altimeter_numbers[] = {
    {"frequency_khz", &AltimeterSettings::frequency_khz},
    {"source_level_db", &AltimeterSettings::source_level_db},
    {"pulse_s", &AltimeterSettings::pulse_s},
    {"interval_s", &AltimeterSettings::interval_s},
    {"range_m", &AltimeterSettings::range_m},
    {"blind_m", &AltimeterSettings::blind_m},
    {"width_deg", &AltimeterSettings::width_rad, degree},
    {"forward_cant_deg", &AltimeterSettings::forward_cant_rad, degree},
    {"sea_bed_strength_db", &AltimeterSettings::sea_bed_strength_db},
    {"threshold_db", &AltimeterSettings::threshold_db},
    {"range_sigma_m", &AltimeterSettings::range_sigma_m},
    {"false_echo_share", &AltimeterSettings::false_echo_share}};

constexpr Number<AdcpSettings> adcp_numbers[] = {
    {"beam_angle_deg", &AdcpSettings::beam_angle_rad, degree},
    {"blank_m", &AdcpSettings::blank_m},
    {"cell_m", &AdcpSettings::cell_m},
    {"ping_interval_s", &AdcpSettings::ping_interval_s},
    {"interval_s", &AdcpSettings::interval_s},
    {"ping_sigma_m_s", &AdcpSettings::ping_sigma_m_s},
    {"neighbour_correlation", &AdcpSettings::neighbour_correlation},
    {"attitude_sigma_deg", &AdcpSettings::attitude_sigma_rad, degree},
    {"sway_sigma_deg", &AdcpSettings::sway_sigma_rad, degree},
    {"reference_sigma_m_s", &AdcpSettings::reference_sigma_m_s},
    {"reference_time_s", &AdcpSettings::reference_time_s}};

constexpr Count<AdcpSettings> adcp_counts[] = {{"cells", &AdcpSettings::cells},
                                               {"pings", &AdcpSettings::pings}};

template <class Settings>
void read_numbers(InputReader& members, std::span<const Number<Settings>> numbers, Settings& settings) {
  for (const auto& number : numbers) {
    if (const auto value = members.number(number.key, any_number))
      settings.*number.member = *value * number.unit;
  }
}

template <class Settings>
void read_counts(InputReader& members, std::span<const Count<Settings>> counts, Settings& settings) {
  for (const auto& count : counts) {
    if (const auto value = members.integer(count.key, 0, most_count)) settings.*count.member = *value;
  }
}

/// Rounds to twelve significant digits, more than any setting has, so that converting 3 degrees to radians
/// and back gives 3.
double twelve_digits(double value) {
  if (value == 0.0) return 0.0;
  const double scale = std::pow(10.0, 12.0 - std::ceil(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

template <class Settings>
void write_numbers(std::span<const Number<Settings>> numbers, const Settings& settings, json& object) {
  for (const auto& number : numbers) {
    const double value = settings.*number.member;
    object[number.key] = number.unit == 1.0 ? value : twelve_digits(value / number.unit);
  }
}

template <class Settings>
void write_counts(std::span<const Count<Settings>> counts, const Settings& settings, json& object) {
  for (const auto& count : counts) object[count.key] = settings.*count.member;
}

void read_water(InputReader& members, const std::string& pointer, SoundWater& water) {
  const json* value = members.member("water");
  if (value == nullptr) return;
  InputReader of_water{*value, pointer + "/water"};
  read_numbers<SoundWater>(of_water, water_numbers, water);
  of_water.refuse_unknown();
  members.refuse_all("", of_water.violations());
}

json water_json(const SoundWater& water) {
  json object;
  write_numbers<SoundWater>(water_numbers, water, object);
  return object;
}

/// Adds the faults of the members, or, if there are none, the faults of the resulting settings.
template <class Settings>
void judge(InputReader& reader, InputReader& members, const std::string& pointer, const Settings& settings) {
  members.refuse_unknown();
  reader.refuse_all("", members.violations());
  if (members.violations().empty()) reader.refuse_all(pointer, settings.violations());
}

}  // namespace

SonarSettings read_sonar(InputReader& reader, const std::string& key) {
  SonarSettings settings;
  const json* value = reader.member(key);
  if (value == nullptr) return settings;
  const std::string pointer = "/" + key;
  InputReader members{*value, pointer};
  read_numbers<SonarSettings>(members, sonar_numbers, settings);
  read_counts<SonarSettings>(members, sonar_counts, settings);
  read_numbers<simulation::BeamPattern>(members, beam_numbers, settings.beam);
  read_water(members, pointer, settings.water);
  judge(reader, members, pointer, settings);
  return settings;
}

AltimeterSettings read_altimeter(InputReader& reader, const std::string& key) {
  AltimeterSettings settings;
  const json* value = reader.member(key);
  if (value == nullptr) return settings;
  const std::string pointer = "/" + key;
  InputReader members{*value, pointer};
  read_numbers<AltimeterSettings>(members, altimeter_numbers, settings);
  read_water(members, pointer, settings.water);
  judge(reader, members, pointer, settings);
  return settings;
}

AdcpSettings read_adcp(InputReader& reader, const std::string& key) {
  AdcpSettings settings;
  const json* value = reader.member(key);
  if (value == nullptr) return settings;
  const std::string pointer = "/" + key;
  InputReader members{*value, pointer};
  read_numbers<AdcpSettings>(members, adcp_numbers, settings);
  read_counts<AdcpSettings>(members, adcp_counts, settings);
  judge(reader, members, pointer, settings);
  return settings;
}

json sonar_json(const SonarSettings& settings) {
  json object;
  write_numbers<SonarSettings>(sonar_numbers, settings, object);
  write_counts<SonarSettings>(sonar_counts, settings, object);
  write_numbers<simulation::BeamPattern>(beam_numbers, settings.beam, object);
  object["water"] = water_json(settings.water);
  return object;
}

json altimeter_json(const AltimeterSettings& settings) {
  json object;
  write_numbers<AltimeterSettings>(altimeter_numbers, settings, object);
  object["water"] = water_json(settings.water);
  return object;
}

json adcp_json(const AdcpSettings& settings) {
  json object;
  write_numbers<AdcpSettings>(adcp_numbers, settings, object);
  write_counts<AdcpSettings>(adcp_counts, settings, object);
  return object;
}

}  // namespace floeplan::codec
