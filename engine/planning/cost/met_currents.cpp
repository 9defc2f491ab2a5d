#include "engine/planning/cost/met_currents.hpp"

#include <cmath>
#include <numeric>

#include "engine/geo/lon_lat.hpp"
#include "engine/motion/disc_encounter.hpp"

namespace floeplan::planning::cost {
namespace {

geo::PlanePoint half_way(geo::PlanePoint a, geo::PlanePoint b) {
  return {std::midpoint(a.x_m, b.x_m), std::midpoint(a.y_m, b.y_m)};
}

/// Rotates a current from the axes of the plane to east and north.
geo::VelocityEn to_east_north(motion::CurrentXy current, core::Radians convergence) {
  const double cosine = std::cos(convergence.value);
  const double sine = std::sin(convergence.value);
  return {{current.x_m_s * cosine + current.y_m_s * sine}, {current.y_m_s * cosine - current.x_m_s * sine}};
}

}  // namespace

CarriedWay carried_between(const Sea& sea, const Sea::Passage& from, const Sea::Passage& to) {
  if (sea.domain().currents() == nullptr) return {};
  const core::Seconds took = to.time - from.time;
  const auto current = (*sea.domain().currents())(half_way(from.point, to.point), from.time + 0.5 * took);
  return current.value_or(motion::CurrentXy{}) * took;
}

std::vector<std::optional<geo::VelocityEn>> leg_currents(const Sea& sea,
                                                         const std::vector<geo::PlanePoint>& route,
                                                         const Schedule& schedule,
                                                         const std::vector<vehicle::Drive>& drives) {
  std::vector<std::optional<geo::VelocityEn>> currents(route.size());
  if (sea.domain().currents() == nullptr) return currents;
  for (std::size_t i = 1; i < route.size(); ++i) {
    const core::Seconds leaves = schedule.leaves(i - 1);
    CarriedWay carried;
    for (const motion::EvenMove& move : sea.drive(route[i - 1], route[i], leaves, drives[i - 1])) {
      carried = carried + carried_between(sea, {move.from, core::Seconds{move.t0_s}},
                                          {move.to, core::Seconds{move.t1_s}});
    }
    const geo::LonLat middle = sea.domain().projection().to_lon_lat(half_way(route[i - 1], route[i]));
    currents[i] = to_east_north(carried.over(schedule.arrivals[i] - leaves),
                                sea.domain().projection().at(middle).convergence);
  }
  return currents;
}

}  // namespace floeplan::planning::cost
