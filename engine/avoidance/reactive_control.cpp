#include "engine/avoidance/reactive_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/avoidance/collision_watch.hpp"
#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr int headings = 72;
constexpr double step_rad = 2.0 * std::numbers::pi / headings;
constexpr int widest_sweep = 60;  // of the headings: beyond 300 degrees the other side is nearer

/// What one look ahead asks of a heading.
struct Look {
  double horizon_s;
  double clearance_m;
};

/// Headings of one moment against the obstacles, each tried when it is first asked for.
class Headings {
 public:
  Headings(geo::PlanePoint own, double through_water_m_s, double goal_rad,
           std::span<const Obstacle> obstacles)
      : own_{own}, speed_{through_water_m_s}, goal_rad_{goal_rad}, obstacles_{obstacles} {}

  [[nodiscard]] double heading_rad(int steps_from_goal) const {
    return goal_rad_ + steps_from_goal * step_rad;
  }
  /// Seconds until contact; infinite: none within the look.
  [[nodiscard]] double contact_s(int steps_from_goal, const Look& look) const {
    const geo::PlanePoint end = moved(own_, heading_rad(steps_from_goal), speed_ * look.horizon_s);
    const std::array<TimedPoint, 2> way{TimedPoint{own_, 0.0}, TimedPoint{end, look.horizon_s}};
    return first_contact(way, obstacles_, look.clearance_m).value_or(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] bool is_free(int steps_from_goal, const Look& look) const {
    return !std::isfinite(contact_s(steps_from_goal, look));
  }
  /// Steps from the goal's heading to the first free one on a side; empty: none.
  [[nodiscard]] std::optional<int> sweep(int side, const Look& look) const {
    for (int k = 1; k <= widest_sweep; ++k) {
      if (is_free(side * k, look)) return k;
    }
    return std::nullopt;
  }

 private:
  geo::PlanePoint own_;
  double speed_;
  double goal_rad_;
  std::span<const Obstacle> obstacles_;
};

}  // namespace

ReactiveCourse ReactiveControl::steer(geo::PlanePoint own_in_water, double through_water_m_s,
                                      double goal_heading_rad, double goal_s,
                                      std::span<const Obstacle> obstacles) {
  const Headings tried{own_in_water, through_water_m_s, goal_heading_rad, obstacles};
  const double watch_s = settings_.watch.count();
  const double imminent_s = settings_.imminent.count();
  // As far and as wide as can be had.
  const std::array<Look, 4> looks{Look{watch_s, settings_.clearance.value},
                                  Look{std::max(0.3 * watch_s, imminent_s), settings_.clearance.value},
                                  Look{imminent_s, settings_.clearance.value},
                                  Look{imminent_s, settings_.close.value}};
  if (tried.is_free(0, {std::min(goal_s, watch_s), settings_.clearance.value})) {
    side_ = 0;
    return {goal_heading_rad, false};
  }
  for (const Look& look : looks) {
    if (side_ != 0) {
      if (const auto k = tried.sweep(side_, look)) return {tried.heading_rad(side_ * *k), false};
    }
    const auto starboard = tried.sweep(1, look);
    const auto port = tried.sweep(-1, look);
    if (!starboard && !port) continue;
    side_ = !port || (starboard && *starboard <= *port) ? 1 : -1;
    return {tried.heading_rad(side_ * (side_ > 0 ? *starboard : *port)), false};
  }

  int best = 0;
  double latest_s = -1.0;
  for (int k = 0; k < headings; ++k) {
    const double contact_s = tried.contact_s(k, {watch_s, 0.0});
    if (contact_s > latest_s) {
      latest_s = contact_s;
      best = k;
    }
  }
  return {tried.heading_rad(best), true};
}

}  // namespace floeplan::avoidance
