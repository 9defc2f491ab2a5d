#include "engine/planning/problem/objective.hpp"

#include <cmath>
#include <stdexcept>

#include "engine/messages/fault.hpp"

namespace floeplan::planning {

using vehicle::Drive;

std::string thruster_use_name(ThrusterUse use) {
  switch (use) {
    case ThrusterUse::automatic: return "auto";
    case ThrusterUse::on: return "on";
    case ThrusterUse::off: return "off";
  }
  throw std::logic_error{"ThrusterUse without a name"};
}

std::optional<ThrusterUse> parse_thruster_use(std::string_view name) {
  for (const ThrusterUse use : {ThrusterUse::automatic, ThrusterUse::on, ThrusterUse::off}) {
    if (name == thruster_use_name(use)) return use;
  }
  return std::nullopt;
}

core::Violations EnergyRules::violations(const vehicle::GliderProfile& profile) const {
  messages::Faults faults;
  const auto is_weight = [](double weight) { return std::isfinite(weight) && weight >= 0.0; };
  faults.require<"wrong-weights">(is_weight(objective.of_time) && is_weight(objective.of_energy) &&
                                      objective.of_time + objective.of_energy > 0.0,
                                  "/objective");
  faults.require<"no-thruster">(thruster != ThrusterUse::on || profile.thruster.has_value(), "/thruster");
  return faults.found();
}

std::vector<Drive> drives(const EnergyRules& rules, const vehicle::GliderProfile& profile) {
  if (!profile.thruster || rules.thruster == ThrusterUse::off) return {Drive::buoyancy};
  if (rules.thruster == ThrusterUse::on) return {Drive::thruster};
  if (rules.objective.is_time()) {
    return {profile.thruster->speed > profile.speed_through_water ? Drive::thruster : Drive::buoyancy};
  }
  return {Drive::buoyancy, Drive::thruster};
}

core::MetresPerSecond drive_speed(const vehicle::GliderProfile& profile, Drive drive) {
  return drive == Drive::thruster ? profile.thruster.value().speed : profile.speed_through_water;
}

std::string drive_name(Drive drive) { return drive == Drive::thruster ? "thruster" : "buoyancy"; }

std::optional<Drive> parse_drive(const std::string& name) {
  for (const Drive drive : {Drive::buoyancy, Drive::thruster})
    if (name == drive_name(drive)) return drive;
  return std::nullopt;
}

}  // namespace floeplan::planning
