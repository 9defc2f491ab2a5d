#include "engine/simulation/sensors/range_rules.hpp"

#include <cstdio>

#include "engine/core/units.hpp"
#include "engine/messages/fault.hpp"

namespace floeplan::simulation {
namespace {

/// The number in the shortest usual form: "0.5", "-26", "1e-05".
std::string written(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

constexpr double rounding_deg = 1e-9;  // tolerance of a bound in degrees after storage in radians

}  // namespace

void RangeRules::require(const std::string& field, double value, double from, double to) {
  if (value >= from && value <= to) return;
  found_.push_back(messages::fault<"out-of-range">(field, written(from), written(to), written(value)));
}

void RangeRules::require_degrees(const std::string& field, double angle_rad, double from_deg, double to_deg) {
  const double angle_deg = core::radians_to_degrees(angle_rad);
  if (angle_deg >= from_deg - rounding_deg && angle_deg <= to_deg + rounding_deg) return;
  require(field, angle_deg, from_deg, to_deg);
}

}  // namespace floeplan::simulation
