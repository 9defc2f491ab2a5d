#include "engine/planning/cost/surfacing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/cost/met_currents.hpp"
#include "engine/planning/ice/nearest_ice.hpp"
#include "engine/planning/problem/position_error.hpp"

namespace floeplan::planning::cost {
namespace {

/// Follows the vehicle from one check of the ice above to the next, and records the surfacing plan.
class Log {
 public:
  Log(const Sea& sea, const PlanRequest& request, geo::PlanePoint start)
      : sea_{sea},
        request_{request},
        here_{{start, core::Seconds{0.0}}},
        fix_{.look = here_},
        last_open_{here_},
        last_sure_{.look = here_} {
    plan.below_ice.emplace();
  }

  /// Takes the next check. Since the last one the vehicle used this propulsion.
  void look(const Sea::Passage& now, vehicle::Drive drive) {
    const Look last = here_;
    here_ = {now, last.error + grown_error(request_.under_ice, sea_.speed(drive), now.time - last.at.time),
             last.carried + carried_between(sea_, last.at, now)};
    const bool open = sea_.domain().overhead().may_surface(now.point, now.time);
    if (was_open_ && !open) ++closed_since_sure_;
    if (request_.under_ice.surfacing_interval) surface_when_due(open);
    if (!(open && was_open_))
      plan.longest_without = std::max(plan.longest_without, now.time - last_open_.at.time);
    if (open) {
      last_open_ = here_;
      if (!request_.under_ice.surfacing_interval) fix_ = next_fix(fix_, here_);
    }
    was_open_ = open;
    const bool sure = open && !ice_within(error_since(last_sure_, here_));
    if (open && !sure && closed_since_sure_ > 0 && !lead_) lead_ = now.point;
    const core::Seconds without_sure = now.time - last_sure_.look.at.time;
    if (!(sure && was_sure_) && closed_since_sure_ > 1 && without_sure > plan.longest_without_sure) {
      plan.longest_without_sure = without_sure;
      if (lead_) plan.missed_lead = sea_.domain().projection().to_lon_lat(*lead_);
    }
    if (sure) {
      last_sure_ = next_fix(last_sure_, here_);
      closed_since_sure_ = 0;
      lead_.reset();
    }
    was_sure_ = sure;
    const core::Metres turn = sea_.domain().overhead().least_upper_turn(now.point, now.time);
    const core::Metres step = sea_.domain().lengths().between(last.at.point, now.point);
    leg_upper_turn_ = std::max(leg_upper_turn_, turn);
    follow_stretch(last.at, turn.value > 0.0);
    const bool below_ice =
        sea_.domain().ice() && sea_.domain().ice()->least_upper_turn(now.point, now.time).value > 0.0;
    ice_free_before_ = below_ice || was_below_ice_ ? core::Metres{0.0} : ice_free_before_ + step;
    was_below_ice_ = below_ice;
    if (sea_.domain().ice() && !sea_.domain().ice()->above(now.point, now.time).known)
      plan.unknown_ice = plan.unknown_ice + step;
    look_beside();
  }

  /// Notes that the last check was at a waypoint: the end of a leg or the start.
  void reach_waypoint() {
    if (below_since_) {
      end_stretch(here_.at);
      below_since_ = here_.at;
    }
    plan.waypoints.push_back(state());
    if (plan.waypoints.size() > 1) plan.waypoints.back().leg_upper_turn = leg_upper_turn_;
    leg_upper_turn_ = plan.waypoints.back().least_upper_turn;
    plan.reckoned.push_back({carried_off(fix_, here_), fix_.assumed});
  }

  SurfacingPlan plan;

 private:
  struct Look {
    Sea::Passage at;
    core::Metres error{};  // position error since the start, as if there were no fix
    CarriedWay carried{};  // displacement by the currents since the start
  };
  /// A position fix, and the current that the vehicle assumes after it.
  struct Fix {
    Look look;
    motion::CurrentXy assumed{};  // zero until the first dive is over
  };
  /// A place where the vehicle could have surfaced.
  struct Opening {
    Look look;
    std::optional<core::Metres> nearest_ice;  // only if within the position error at that time
    core::Metres room;  // distance to the ice minus the position error, negative; unused if no ice is near

    [[nodiscard]] bool is_clear() const { return !nearest_ice; }
    [[nodiscard]] bool is_as_good_as(const Opening& other) const {
      return is_clear() || (!other.is_clear() && room >= other.room);
    }
  };

  /// Values for the plan at the last check.
  [[nodiscard]] SurfacingState state() const {
    const auto [point, time] = here_.at;
    SurfacingState state{.may_surface = sea_.domain().overhead().may_surface(point, time),
                         .since_surfacing = time - last_open_.at.time,
                         .position_error = error_at(here_),
                         .least_upper_turn = sea_.domain().overhead().least_upper_turn(point, time),
                         .ice_free_before = ice_free_before_,
                         .error_without_fix = here_.error};
    state.nearest_ice = ice_within(farthest_ice_told);
    if (state.may_surface) state.since_surfacing = core::Seconds{0.0};
    return state;
  }

  /// Distance on the ground to the nearest ice at the last check; empty if it exceeds `distance`.
  [[nodiscard]] std::optional<core::Metres> ice_within(core::Metres distance) const {
    if (!sea_.domain().ice()) return std::nullopt;
    const auto& [point, time] = here_.at;
    const auto ice = ice::nearest_ice_within(distance, *sea_.domain().ice(), point, time);
    if (!ice) return std::nullopt;
    return sea_.domain().lengths().between(point, {point.x_m + ice->value, point.y_m});
  }

  /// Begins or ends the stretch below ice or icebergs between two checks.
  void follow_stretch(const Sea::Passage& last, bool is_below) {
    if (is_below == below_since_.has_value()) return;
    const Sea::Passage between{{std::midpoint(last.point.x_m, here_.at.point.x_m),
                                std::midpoint(last.point.y_m, here_.at.point.y_m)},
                               last.time + (here_.at.time - last.time) / 2.0};
    if (is_below) {
      below_since_ = between;
    } else {
      end_stretch(between);
    }
  }
  void end_stretch(const Sea::Passage& until) {
    const Sea::Passage since = *std::exchange(below_since_, std::nullopt);
    if (until.time <= since.time) return;
    const geo::LonLat from = sea_.domain().projection().to_lon_lat(since.point);
    const geo::LonLat to = sea_.domain().projection().to_lon_lat(until.point);
    plan.below_ice->push_back({plan.waypoints.size(), from, to, request_.depart + since.time,
                               until.time - since.time, geo::geodesic_between(from, to).length});
  }

  void look_beside() {
    if (!sea_.domain().ice()) return;
    const core::Metres error = error_at(here_);
    const auto& [point, time] = here_.at;
    const core::Metres turn = ice::deepest_turn_within(error, *sea_.domain().ice(), point, time);
    if (turn > plan.ice_beside.upper_turn)
      plan.ice_beside = {turn, error, sea_.domain().projection().to_lon_lat(point)};
  }

  /// Position error since a fix: dead-reckoning error, and displacement by currents beyond the assumed
  /// current.
  [[nodiscard]] static core::Metres error_since(const Fix& fix, const Look& look) {
    return look.error - fix.look.error + carried_off(fix, look).length();
  }
  [[nodiscard]] static CarriedWay carried_off(const Fix& fix, const Look& look) {
    return look.carried - fix.look.carried - fix.assumed * (look.at.time - fix.look.at.time);
  }

  /// The fix at `look`. From it the vehicle computes the mean current since the fix before.
  [[nodiscard]] static Fix next_fix(const Fix& before, const Look& look) {
    const core::Seconds under_water = look.at.time - before.look.at.time;
    if (under_water.count() <= 0.0) return {look, before.assumed};
    return {look, (look.carried - before.look.carried).over(under_water)};
  }

  [[nodiscard]] core::Metres error_at(const Look& look) const { return error_since(fix_, look); }

  [[nodiscard]] bool is_due() const {
    return here_.at.time - fix_.look.at.time > *request_.under_ice.surfacing_interval;
  }

  [[nodiscard]] Opening opening_here() const {
    const core::Metres error = error_at(here_);
    const auto ice = ice_within(error);
    return {here_, ice, ice.value_or(error) - error};
  }

  /// Plans a surfacing at the best place since the last fix, once the interval is over and no better place
  /// follows.
  void surface_when_due(bool open) {
    std::optional<Opening> now = open ? std::optional{opening_here()} : std::nullopt;
    const auto comes_no_better = [&] {
      return best_opening_->is_clear() || !now || !now->is_as_good_as(*best_opening_);
    };
    if (best_opening_ && is_due() && comes_no_better()) {
      surface(*best_opening_);
      if (open) now = opening_here();  // the position error is smaller after that fix
    }
    if (now && (!best_opening_ || now->is_as_good_as(*best_opening_))) best_opening_ = now;
    if (best_opening_ && is_due() && best_opening_->is_clear()) surface(*best_opening_);
  }

  void surface(const Opening& opening) {
    const Look look = opening.look;
    plan.surfacings.push_back({sea_.domain().projection().to_lon_lat(look.at.point),
                               request_.depart + look.at.time, error_at(look), opening.nearest_ice});
    fix_ = next_fix(fix_, look);
    best_opening_.reset();
  }

  const Sea& sea_;
  const PlanRequest& request_;
  Look here_;
  Fix fix_;
  Look last_open_;
  Fix last_sure_;  // last place where no ice lies within the position error since such a place before
  std::optional<Opening> best_opening_{};  // since the last fix; of equally good places the last
  bool was_open_{true};                    // the vehicle starts at the surface
  bool was_sure_{true};
  /// Stretches where it may not surface; between two of them lies a lead that it could miss.
  int closed_since_sure_{0};
  std::optional<geo::PlanePoint> lead_;  // the first since then that the vehicle could miss
  core::Metres leg_upper_turn_{};  // deepest upper turn since the last waypoint
  core::Metres
      ice_free_before_{};  // counted from the first check without ice, because the water before it may be covered
  bool was_below_ice_{false};                  // at the last check
  std::optional<Sea::Passage> below_since_{};  // ice or icebergs, on this leg
};

void look_while_waiting(Log& log, geo::PlanePoint place, core::Seconds from, core::Seconds until,
                        vehicle::Drive drive) {
  constexpr core::Seconds between_looks{900.0};
  while (from < until) {
    from = std::min(from + between_looks, until);
    log.look({place, from}, drive);
  }
}

}  // namespace

SurfacingPlan plan_surfacings(const Sea& sea, const PlanRequest& request,
                              const std::vector<geo::PlanePoint>& route, const Schedule& schedule,
                              const std::vector<vehicle::Drive>& drives) {
  const core::Metres step = sea.domain().overhead().look();
  Log log{sea, request, route.front()};
  log.look({route.front(), schedule.arrivals.front()}, sea.drives().front());
  log.reach_waypoint();
  for (std::size_t i = 1; i < route.size(); ++i) {
    const vehicle::Drive drive = drives[i - 1];
    const core::Seconds leaves = schedule.leaves(i - 1);
    look_while_waiting(log, route[i - 1], schedule.arrivals[i - 1], leaves, drive);
    for (const Sea::Passage& passage : sea.passages(route[i - 1], route[i], leaves, step, drive))
      log.look(passage, drive);
    log.reach_waypoint();
  }
  return std::move(log.plan);
}

}  // namespace floeplan::planning::cost
