#include "engine/planning/surfacing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace floeplan::planning {
namespace {

/// Follows the vehicle from look to look.
class Log {
 public:
  Log(const Sea& sea, const PlanRequest& request, geo::PlanePoint start)
      : sea_{sea},
        request_{request},
        growth_m_s_{request.under_ice.dead_reckoning_share * request.vehicle.speed_through_water.value +
                    request.under_ice.current_uncertainty.value},
        fix_{start, core::Seconds{0.0}},
        last_open_{fix_} {}

  void look(const Sea::Passage& now) {
    const bool open = sea_.may_surface(now.point, now.time);
    surface_when_due(now, open);
    if (!(open && was_open_))
      plan.longest_without = std::max(plan.longest_without, now.time - last_open_.time);
    if (open) {
      last_open_ = now;
      if (!request_.under_ice.surfacing_interval) fix_ = now;
    }
    was_open_ = open;
    if (sea_.ice() && !sea_.ice()->above(now.point, now.time).known)
      plan.unknown_ice = plan.unknown_ice + sea_.ground_length(here_.value_or(now).point, now.point);
    here_ = now;
  }

  [[nodiscard]] SurfacingState state(const Sea::Passage& now) const {
    SurfacingState state{.may_surface = sea_.may_surface(now.point, now.time),
                         .since_surfacing = now.time - last_open_.time,
                         .position_error = error_at(now.time),
                         .least_upper_turn = sea_.least_upper_turn(now.point, now.time)};
    if (state.may_surface) state.since_surfacing = core::Seconds{0.0};
    return state;
  }

  SurfacingPlan plan;

 private:
  [[nodiscard]] core::Metres error_at(core::Seconds time) const {
    return core::Metres{growth_m_s_ * (time - fix_.time).count()};
  }

  /// The last look before the interval is over, or the first after it when the vehicle was under ice then.
  void surface_when_due(const Sea::Passage& now, bool open) {
    const auto interval = request_.under_ice.surfacing_interval;
    if (!interval || now.time - fix_.time <= *interval) return;
    if (last_open_.time > fix_.time) surface(last_open_);
    if (open && now.time - fix_.time > *interval) surface(now);
  }

  void surface(const Sea::Passage& at) {
    plan.surfacings.push_back(
        {sea_.projection().to_lon_lat(at.point), request_.depart + at.time, error_at(at.time)});
    fix_ = at;
  }

  const Sea& sea_;
  const PlanRequest& request_;
  double growth_m_s_;
  Sea::Passage fix_;
  Sea::Passage last_open_;
  bool was_open_{true};  // the vehicle starts at the surface
  std::optional<Sea::Passage> here_;
};

void look_while_waiting(Log& log, geo::PlanePoint place, core::Seconds from, core::Seconds until) {
  constexpr core::Seconds between_looks{900.0};
  while (from < until) {
    from = std::min(from + between_looks, until);
    log.look({place, from});
  }
}

}  // namespace

SurfacingPlan plan_surfacings(const Sea& sea, const PlanRequest& request,
                              const std::vector<geo::PlanePoint>& route, const Schedule& schedule) {
  const core::Metres step = sea.surfacing_look();
  Log log{sea, request, route.front()};
  const Sea::Passage start{route.front(), schedule.arrivals.front()};
  log.look(start);
  log.plan.waypoints.push_back(log.state(start));
  for (std::size_t i = 1; i < route.size(); ++i) {
    look_while_waiting(log, route[i - 1], schedule.arrivals[i - 1], schedule.leaves(i - 1));
    for (const Sea::Passage& passage : sea.passages(route[i - 1], route[i], schedule.leaves(i - 1), step))
      log.look(passage);
    log.plan.waypoints.push_back(log.state({route[i], schedule.arrivals[i]}));
  }
  return std::move(log.plan);
}

}  // namespace floeplan::planning
