#include "engine/planning/problem/departure_rules.hpp"

#include <cmath>
#include <string>

#include "engine/core/utc_text.hpp"

namespace floeplan::planning {
namespace {

constexpr double shortest_step_s = 1.0;

/// Steps that fit into the window, a rounding error of the last one included.
double steps_within(core::UtcTime depart, core::UtcTime until, core::Seconds step) {
  return std::floor((until - depart) / step + 1e-9);
}

}  // namespace

std::vector<core::UtcTime> DepartureRules::departures(core::UtcTime depart) const {
  std::vector<core::UtcTime> result{depart};
  if (!until) return result;
  const auto steps = static_cast<int>(steps_within(depart, *until, step));
  for (int i = 1; i <= steps; ++i) result.push_back(depart + i * step);
  return result;
}

core::Violations DepartureRules::violations(core::UtcTime depart) const {
  core::Violations found;
  const auto refuse = [&](const char* field, std::string rule) { found.push_back({field, std::move(rule)}); };
  if (until && arrive_by) refuse("/arrive_by", "cannot be asked for together with depart_until");
  if (arrive_by && *arrive_by <= depart) {
    refuse("/arrive_by", "must be after the earliest departure, " + core::iso8601(depart));
  }
  if (!until) return found;

  if (*until < depart) {
    refuse("/depart_until", "must not be before the first departure, " + core::iso8601(depart));
  }
  if (!(step.count() >= shortest_step_s)) {
    refuse("/depart_step", "must be at least one second, as PT1H");
    return found;
  }
  if (steps_within(depart, *until, step) >= most_departures) {
    refuse("/depart_step", "makes more than " + std::to_string(most_departures) +
                               " departures; choose a longer step or a shorter window");
  }
  return found;
}

}  // namespace floeplan::planning
