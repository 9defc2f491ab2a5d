#include "engine/simulation/sensors/adcp_settings.hpp"

#include "engine/simulation/sensors/range_rules.hpp"

namespace floeplan::simulation {

core::Violations AdcpSettings::violations() const {
  RangeRules rules;
  rules.require_degrees("/beam_angle_deg", beam_angle_rad, 10.0, 45.0);
  rules.require("/blank_m", blank_m, 0.1, 50.0);
  rules.require("/cell_m", cell_m, 0.25, 32.0);
  rules.require("/cells", cells, 2, most_adcp_cells);
  rules.require("/pings", pings, 1, 1000);
  rules.require("/ping_interval_s", ping_interval_s, 0.1, 60.0);
  rules.require("/interval_s", interval_s, 1.0, 86400.0);
  rules.require("/ping_sigma_m_s", ping_sigma_m_s, 0.0, 2.0);
  rules.require("/neighbour_correlation", neighbour_correlation, 0.0, 0.5);
  rules.require_degrees("/attitude_sigma_deg", attitude_sigma_rad, 0.0, 10.0);
  rules.require_degrees("/sway_sigma_deg", sway_sigma_rad, 0.0, 10.0);
  rules.require("/reference_sigma_m_s", reference_sigma_m_s, 0.0, 2.0);
  rules.require("/reference_time_s", reference_time_s, 1.0, 1e7);
  if (pings * ping_interval_s > interval_s + 1e-9)
    rules.refuse("/pings",
                 "must all fit between two profiles: pings times ping_interval_s at most interval_s");
  return rules.found();
}

}  // namespace floeplan::simulation
