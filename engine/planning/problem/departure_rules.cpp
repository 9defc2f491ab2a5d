#include "engine/planning/problem/departure_rules.hpp"

#include <cmath>

#include "engine/messages/fault.hpp"

namespace floeplan::planning {
namespace {

constexpr double shortest_step_s = 1.0;

/// Number of steps that fit into the window. The last may end after the window by a rounding error.
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
  messages::Faults faults;
  faults.require<"arrival-and-window">(!until || !arrive_by, "/arrive_by");
  faults.require<"arrival-before-departure">(!arrive_by || *arrive_by > depart, "/arrive_by", depart);
  if (!until) return faults.found();

  faults.require<"window-ends-before-departure">(*until >= depart, "/depart_until", depart);
  if (faults.require<"not-at-least">(step.count() >= shortest_step_s, "/depart_step", "one second, as PT1H"))
    faults.require<"too-many-departures">(steps_within(depart, *until, step) < most_departures,
                                          "/depart_step", most_departures);
  return faults.found();
}

}  // namespace floeplan::planning
