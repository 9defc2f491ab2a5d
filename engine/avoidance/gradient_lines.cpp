#include "engine/avoidance/gradient_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "engine/avoidance/disc_set.hpp"
#include "engine/avoidance/steering.hpp"

namespace floeplan::avoidance {
namespace {

constexpr int headings = 72;
constexpr double step_rad = 2.0 * std::numbers::pi / headings;
constexpr int widest_sweep = 60;  // in steps of headings: beyond 300 degrees the other side is nearer

/// A condition on headings: no contact within a time and a clearance.
struct Look {
  double horizon_s;
  double clearance_m;
};

/// Headings at one time against the obstacles of one look. Each is tested when first needed.
class Headings {
 public:
  Headings(geo::PlanePoint own, double through_water_m_s, double goal_rad,
           std::span<const Obstacle> obstacles, const Look& look)
      : own_{own},
        goal_rad_{goal_rad},
        horizon_s_{look.horizon_s},
        way_m_{through_water_m_s * look.horizon_s},
        discs_{obstacles,
               {.from = own,
                .now_s = 0.0,
                .until_s = look.horizon_s,
                .clearance_m = look.clearance_m,
                .reach_m = way_m_}} {}

  [[nodiscard]] double heading_rad(int steps_from_goal) const {
    return goal_rad_ + steps_from_goal * step_rad;
  }
  /// Time to contact in seconds; infinite: none within the look.
  [[nodiscard]] double contact_s(int steps_from_goal) const {
    return discs_.first_touch(move(steps_from_goal)).value_or(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] bool is_free(int steps_from_goal) const { return !discs_.is_touched(move(steps_from_goal)); }
  /// Number of steps from the goal's heading to the first free one on this side; empty: none.
  [[nodiscard]] std::optional<int> sweep(int side) const {
    for (int k = 1; k <= widest_sweep; ++k) {
      if (is_free(side * k)) return k;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] motion::EvenMove move(int steps_from_goal) const {
    return {own_, moved(own_, heading_rad(steps_from_goal), way_m_), 0.0, horizon_s_};
  }

  geo::PlanePoint own_;
  double goal_rad_;
  double horizon_s_;
  double way_m_;
  DiscSet discs_;
};

}  // namespace

GradientCourse GradientLines::steer(geo::PlanePoint own_in_water, double through_water_m_s,
                                    double goal_heading_rad, double goal_s,
                                    std::span<const Obstacle> obstacles) {
  const auto headings_of = [&](const Look& look) {
    return Headings{own_in_water, through_water_m_s, goal_heading_rad, obstacles, look};
  };
  const double watch_s = settings_.watch.count();
  const double imminent_s = settings_.imminent.count();
  // Looks from the farthest and widest to the nearest and narrowest. The first with a free heading decides.
  const std::array<Look, 4> looks{Look{watch_s, settings_.clearance.value},
                                  Look{std::max(0.3 * watch_s, imminent_s), settings_.clearance.value},
                                  Look{imminent_s, settings_.clearance.value},
                                  Look{imminent_s, settings_.close.value}};
  if (headings_of({std::min(goal_s, watch_s), settings_.clearance.value}).is_free(0)) {
    side_ = 0;
    return {goal_heading_rad, false};
  }
  for (const Look& look : looks) {
    const Headings tried = headings_of(look);
    if (side_ != 0) {
      if (const auto k = tried.sweep(side_)) return {tried.heading_rad(side_ * *k), false};
    }
    const auto starboard = tried.sweep(1);
    const auto port = tried.sweep(-1);
    if (!starboard && !port) continue;
    side_ = !port || (starboard && *starboard <= *port) ? 1 : -1;
    return {tried.heading_rad(side_ * (side_ > 0 ? *starboard : *port)), false};
  }

  const Headings tried = headings_of({watch_s, 0.0});
  int best = 0;
  double latest_s = -1.0;
  for (int k = 0; k < headings; ++k) {
    const double contact_s = tried.contact_s(k);
    if (contact_s > latest_s) {
      latest_s = contact_s;
      best = k;
    }
  }
  return {tried.heading_rad(best), true};
}

}  // namespace floeplan::avoidance
