#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/motion/crabbing.hpp"
#include "engine/motion/plane_current.hpp"
#include "engine/motion/plane_edge.hpp"

namespace floeplan::motion {

/// A stretch of an edge on which any kind of current is evaluated point by point.
template <PlaneCurrent Current>
struct SampledStretch {
  static constexpr bool is_bounded = false;

  const Current& current;
  const PlaneEdge& edge;
  EdgeDirection direction;
  double end_way_m{};
  double end_s{};

  [[nodiscard]] std::optional<CurrentOnEdge> at(double way_m, double t_s) const {
    const double share = std::min(way_m / edge.ground_length.value, 1.0);
    const auto c = current(geo::PlanePoint{edge.from.x_m + share * (edge.to.x_m - edge.from.x_m),
                                           edge.from.y_m + share * (edge.to.y_m - edge.from.y_m)},
                           core::Seconds{t_s});
    if (!c) return std::nullopt;
    return direction(*c);
  }

  /// Estimate from three places. It assumes that between them the room falls by at most its range over the
  /// three. Zero or negative if the current is unknown.
  [[nodiscard]] double least_room(const Crabbing& crabbing, double way0_m, double t0_s, double way1_m,
                                  double t1_s) const {
    const auto room = [&](double way_m, double t_s) {
      const auto c = at(way_m, t_s);
      return c ? crabbing.room(*c) : -std::numeric_limits<double>::infinity();
    };
    const auto [least, most] = std::minmax(
        {room(way0_m, t0_s), room(0.5 * (way0_m + way1_m), 0.5 * (t0_s + t1_s)), room(way1_m, t1_s)});
    return least - (most - least);
  }
};

/// An edge divided into stretches, on each of which the current is sampled. No stretch is longer than the
/// distance over which the current changes.
template <PlaneCurrent Current>
class SampledLine {
 public:
  SampledLine(const PlaneEdge& edge, const Current& current, core::Metres longest_step,
              core::Seconds longest_duration)
      : longest_step_{longest_step},
        longest_duration_{longest_duration},
        stretch_{current, edge, EdgeDirection{edge}, 0.0, 0.0} {}

  bool begin(core::Seconds depart) {
    stretch_.end_way_m = longest_step_.value;
    stretch_.end_s = (depart + longest_duration_).count();
    return true;
  }
  [[nodiscard]] const SampledStretch<Current>& stretch() const { return stretch_; }
  bool pass_way() {
    stretch_.end_way_m += longest_step_.value;
    return true;
  }
  bool pass_time() {
    stretch_.end_s += longest_duration_.count();
    return true;
  }

 private:
  core::Metres longest_step_;
  core::Seconds longest_duration_;
  SampledStretch<Current> stretch_;
};

}  // namespace floeplan::motion
