#include "engine/simulation/sensors/sonar_settings.hpp"

#include <cmath>
#include <string>

#include "engine/avoidance/sensed.hpp"
#include "engine/core/units.hpp"
#include "engine/simulation/sensors/range_rules.hpp"

namespace floeplan::simulation {

core::Violations SonarSettings::violations() const {
  RangeRules rules;
  rules.require("/frequency_khz", frequency_khz, 10.0, 1000.0);
  rules.require("/source_level_db", source_level_db, 100.0, 240.0);
  rules.require("/pulse_s", pulse_s, 1e-5, 0.05);
  rules.require("/interval_s", interval_s, 0.2, 600.0);
  rules.require("/range_m", range_m, 10.0, 1000.0);
  rules.require("/blind_m", blind_m, 0.1, 50.0);
  rules.require("/beams", beams, 1, most_beams);
  rules.require("/rows", rows, 1, 9);
  rules.require_degrees("/beam_step_deg", beam_step_rad, 0.1, 90.0);
  rules.require_degrees("/row_step_deg", row_step_rad, 0.1, 90.0);
  rules.require_degrees("/tilt_deg", tilt_rad, -90.0, 90.0);
  rules.require_degrees("/beam_width_deg", beam.width_rad, 0.5, 40.0);
  rules.require_degrees("/beam_height_deg", beam.height_rad, 0.5, 40.0);
  rules.require("/side_lobes_db", beam.side_lobes_db, -60.0, 0.0);
  rules.require("/receiver_noise_db", receiver_noise_db, -50.0, 150.0);
  rules.require("/false_alarms_per_ping", false_alarms_per_ping, 0.0, 20.0);
  rules.require("/most_returns_per_beam", most_returns_per_beam, 1, 20);
  rules.require("/ice_strength_db", ice_strength_db, -60.0, 0.0);
  rules.require("/sea_bed_strength_db", sea_bed_strength_db, -60.0, 0.0);
  rules.require("/volume_strength_db", volume_strength_db, -120.0, -20.0);
  rules.require("/sound_speed_error_share", sound_speed_error_share, -0.05, 0.05);
  rules.require("/water/temperature_deg_c", water.temperature_deg_c, -2.0, 35.0);
  rules.require("/water/salinity_g_kg", water.salinity_g_kg, 0.0, 45.0);
  rules.require("/water/ph", water.ph, 7.0, 9.0);
  rules.require("/water/depth_m", water.depth_m, 0.0, 7000.0);
  rules.require("/water/speed_m_s", water.speed_m_s, 1350.0, 1650.0);
  rules.require("/water/wind_m_s", water.wind_m_s, 0.0, 40.0);
  if (!rules.found().empty()) return rules.found();
  if (beams * rows > most_beams)
    rules.refuse("/beams", "times rows must be at most " + std::to_string(most_beams));
  if (beams * rows * most_returns_per_beam > static_cast<int>(avoidance::SonarPing::most_returns))
    rules.refuse("/most_returns_per_beam", "times all beams must be at most " +
                                               std::to_string(avoidance::SonarPing::most_returns) +
                                               ", what the system on board takes of a ping");
  if (0.5 * (beams - 1) * beam_step_rad > core::degrees_to_radians(90.0))
    rules.refuse("/beam_step_deg", "times the beams of a row must be at most 180 degrees: it looks forward");
  if (std::abs(tilt_rad) + 0.5 * (rows - 1) * row_step_rad > core::degrees_to_radians(90.0))
    rules.refuse("/row_step_deg", "must keep every row within 90 degrees of the hull's axis");
  if (blind_m >= range_m) rules.refuse("/blind_m", "must be below range_m");
  if (2.0 * range_m / water.speed_m_s > interval_s)
    rules.refuse("/interval_s", "must leave the echo time to come back from range_m");
  return rules.found();
}

}  // namespace floeplan::simulation
