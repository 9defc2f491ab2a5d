#include "engine/simulation/sensors/altimeter.hpp"

#include <numbers>
#include <stdexcept>

#include "engine/simulation/sensors/beam_pattern.hpp"
#include "engine/simulation/sensors/range_rules.hpp"

namespace floeplan::simulation {

core::Violations AltimeterSettings::violations() const {
  RangeRules rules;
  rules.require("/frequency_khz", frequency_khz, 10.0, 1000.0);
  rules.require("/source_level_db", source_level_db, 100.0, 240.0);
  rules.require("/pulse_s", pulse_s, 1e-5, 0.05);
  rules.require("/interval_s", interval_s, 0.2, 3600.0);
  rules.require("/range_m", range_m, 5.0, 1000.0);
  rules.require("/blind_m", blind_m, 0.0, 10.0);
  rules.require_degrees("/width_deg", width_rad, 0.5, 40.0);
  rules.require_degrees("/forward_cant_deg", forward_cant_rad, -90.0, 90.0);
  rules.require("/sea_bed_strength_db", sea_bed_strength_db, -60.0, 0.0);
  rules.require("/threshold_db", threshold_db, 0.0, 60.0);
  rules.require("/range_sigma_m", range_sigma_m, 0.0, 10.0);
  rules.require("/false_echo_share", false_echo_share, 0.0, 1.0);
  return rules.found();
}

Altimeter::Altimeter(const AltimeterSettings& settings) : settings_{settings} {
  if (!settings_.violations().empty())
    throw std::invalid_argument{"these settings of an altimeter cannot be simulated"};
  const BeamPattern beam{settings_.width_rad, settings_.width_rad};
  absorption_db_m_ = absorption_db_m(settings_.frequency_khz, settings_.water);
  noise_db_ = noise_spectrum_db(settings_.frequency_khz, settings_.water.wind_m_s) -
              10.0 * std::log10(settings_.pulse_s) - directivity_db(beam);
  beam_sr_ = reverberation_angle_sr(beam);

  const double cant = settings_.forward_cant_rad;
  rays_[0] = {std::sin(cant), 0.0, std::cos(cant)};
  const double half = 0.5 * settings_.width_rad;
  for (std::size_t i = 1; i < rays_.size(); ++i) {
    const double around =
        2.0 * std::numbers::pi * static_cast<double>(i - 1) / static_cast<double>(rays_.size() - 1);
    const double ahead = std::sin(half) * std::cos(around);
    rays_[i] = {std::cos(half) * std::sin(cant) + ahead * std::cos(cant), std::sin(half) * std::sin(around),
                std::cos(half) * std::cos(cant) - ahead * std::sin(cant)};
  }
}

bool Altimeter::is_heard(const RayHit& hit) const {
  if (hit.scatterer == Scatterer::open_surface || hit.range_m < settings_.blind_m || hit.cosine <= 0.0)
    return false;
  const double echo_db = settings_.source_level_db - 20.0 * std::log10(hit.range_m) -
                         2.0 * absorption_db_m_ * hit.range_m + settings_.sea_bed_strength_db +
                         10.0 * std::log10(beam_sr_ * hit.cosine);
  return echo_db >= noise_db_ + settings_.threshold_db;
}

}  // namespace floeplan::simulation
