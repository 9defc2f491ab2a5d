#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/messages/plan_messages.hpp"
#include "engine/planning/currents/flown_depths.hpp"
#include "engine/planning/publish/warnings.hpp"

namespace floeplan::planning::publish {
namespace {

/// Share of the speed through the water that a route may need without a warning. A vehicle that needs more
/// has too small a reserve for forecast errors. A judgement.
constexpr double hardly_enough = 0.95;
/// Share of the depths flown that may lie below the known currents without a warning: a smaller part hardly
/// changes the mean current. A judgement.
constexpr double most_unknown = 0.25;

/// Divides each leg of a route into equal pieces of at most 500 m (shorter than the cells of current models)
/// and calls `visit(middle, length)` for each piece.
template <class Visit>
void for_each_stretch_of(const std::vector<geo::PlanePoint>& route, const Visit& visit) {
  constexpr double step_m = 500.0;
  for (std::size_t i = 1; i < route.size(); ++i) {
    const double length_m = geo::distance_m(route[i - 1], route[i]);
    const int steps = std::max(1, static_cast<int>(std::ceil(length_m / step_m)));
    for (int step = 0; step < steps; ++step) {
      const double share = (step + 0.5) / steps;
      visit(geo::PlanePoint{std::lerp(route[i - 1].x_m, route[i].x_m, share),
                            std::lerp(route[i - 1].y_m, route[i].y_m, share)},
            length_m / steps);
    }
  }
}

std::optional<messages::Message> of_extended(const cost::Sea& sea,
                                             const std::vector<geo::PlanePoint>& route) {
  double extended_m = 0.0;
  double all_m = 0.0;
  for_each_stretch_of(route, [&](geo::PlanePoint point, double length_m) {
    all_m += length_m;
    if (sea.domain().currents()->is_extended(point)) extended_m += length_m;
  });
  if (extended_m == 0.0) return std::nullopt;
  return messages::plan_message<"currents-of-nearest-water">(std::max(1.0, 100.0 * extended_m / all_m));
}

/// The depth down to which the currents of a column are known: half way to the first level without a current.
/// Empty if they are known down to the last level, or if there is no water.
std::optional<core::Metres> known_down_to(const ocean::CurrentGrid& currents, geo::LonLat place) {
  const ocean::CurrentGrid::Samples& samples = currents.samples();
  const auto at = samples.depths_m ? samples.grid.locate(place) : std::nullopt;
  if (!at) return std::nullopt;
  const auto nearest = [](const ocean::AxisPosition& position) {
    return position.fraction < 0.5 ? position.lower : position.upper;
  };
  const std::size_t node = nearest(at->y) * samples.grid.x().size() + nearest(at->x);
  const std::vector<double>& levels_m = samples.depths_m->nodes();
  std::size_t wet = 0;
  while (wet < levels_m.size() && !std::isnan(samples.u[wet * samples.grid.size() + node])) ++wet;
  if (wet == 0 || wet == levels_m.size()) return std::nullopt;
  return core::Metres{0.5 * (levels_m[wet - 1] + levels_m[wet])};
}

std::optional<messages::Message> of_unknown_depths(const cost::Sea& sea,
                                                   const ocean::Environment& environment,
                                                   const PlanRequest& request,
                                                   const std::vector<geo::PlanePoint>& route) {
  const currents::FlownDepths depths{request.vehicle.dive_limits(), environment.bathymetry};
  double unknown_m = 0.0;
  double worst_m = 0.0;
  core::Metres known{0.0};
  core::Metres flown{0.0};
  geo::LonLat worst{};
  for_each_stretch_of(route, [&](geo::PlanePoint point, double length_m) {
    const geo::LonLat place = sea.domain().projection().to_lon_lat(point);
    const auto down_to = known_down_to(*environment.currents, place);
    if (!down_to) return;
    const vehicle::DiveBand band = depths.at(place);
    const core::Metres missing = band.bottom - std::max(*down_to, band.top);
    if (missing.value <= most_unknown * band.thickness().value) return;
    unknown_m += length_m;
    if (missing.value <= worst_m) return;
    worst_m = missing.value;
    known = *down_to;
    flown = band.bottom;
    worst = place;
  });
  if (unknown_m == 0.0) return std::nullopt;
  return messages::plan_message<"dives-below-currents">(unknown_m / 1000.0, flown.value, known.value)
      .at(worst);
}

/// Share of its speed through the water that the vehicle needs to hold a course and make way on it.
double needed_share(const motion::CurrentXy& current, geo::PlanePoint from, geo::PlanePoint to,
                    core::MetresPerSecond through_water) {
  const double length_m = geo::distance_m(from, to);
  const double x = (to.x_m - from.x_m) / length_m;
  const double y = (to.y_m - from.y_m) / length_m;
  const double along = current.x_m_s * x + current.y_m_s * y;
  const double across = current.y_m_s * x - current.x_m_s * y;
  return (along < 0.0 ? std::hypot(along, across) : std::abs(across)) / through_water.value;
}

std::optional<messages::Message> of_hardly_enough_speed(const cost::Sea& sea, const PlanRequest& request,
                                                        const std::vector<geo::PlanePoint>& route,
                                                        const cost::Schedule& schedule,
                                                        const std::vector<vehicle::Drive>& drives) {
  constexpr double looks = 16.0;  // samples along a leg; currents change little between them
  std::size_t legs = 0;
  double most = 0.0;
  cost::Sea::Passage where{};
  std::size_t leg_there = 0;
  for (std::size_t leg = 0; leg + 1 < route.size(); ++leg) {
    const core::Metres look{geo::distance_m(route[leg], route[leg + 1]) / looks};
    if (!(look.value > 0.0)) continue;
    double most_on_leg = 0.0;
    for (const cost::Sea::Passage& passage :
         sea.passages(route[leg], route[leg + 1], schedule.leaves(leg), look, drives[leg])) {
      const auto current = (*sea.domain().currents())(passage.point, passage.time);
      if (!current) continue;
      const double share = needed_share(*current, route[leg], route[leg + 1], sea.speed(drives[leg]));
      most_on_leg = std::max(most_on_leg, share);
      if (share <= most) continue;
      most = share;
      where = passage;
      leg_there = leg + 1;
    }
    if (most_on_leg > hardly_enough) ++legs;
  }
  if (legs == 0) return std::nullopt;
  return messages::plan_message<"hardly-enough-speed">(
             legs, 100.0 * hardly_enough, leg_there, request.depart + where.time, 100.0 * std::min(most, 1.0))
      .at(sea.domain().projection().to_lon_lat(where.point));
}

}  // namespace

std::vector<messages::Message> water_warnings(const cost::Sea& sea, const ocean::Environment& environment,
                                              const PlanRequest& request,
                                              const std::vector<geo::PlanePoint>& route,
                                              const cost::Schedule& schedule,
                                              const std::vector<vehicle::Drive>& drives) {
  if (!sea.domain().currents() || !environment.currents) return {};
  std::vector<messages::Message> told;
  for (auto& message : {of_extended(sea, route), of_unknown_depths(sea, environment, request, route),
                        of_hardly_enough_speed(sea, request, route, schedule, drives)})
    if (message) told.push_back(*message);
  return told;
}

}  // namespace floeplan::planning::publish
