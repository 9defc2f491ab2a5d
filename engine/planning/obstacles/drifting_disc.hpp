#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/motion/disc_encounter.hpp"
#include "engine/planning/obstacles/iceberg_track.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::obstacles {

/// The disc that one iceberg keeps a vehicle out of, as it drifts and grows: half the length, the margin and the error
/// of the position. After the end of its forecast it stays as it is then.
/// Units    metres of the plane; times count from the epoch of the forecast
/// Threads  const members may be called from several threads at once
class DriftingDisc {
 public:
  /// `track` holds at least one point; `hull` is half the length, on the ground. `rounding`: kept besides, of which no
  /// figure tells.
  DriftingDisc(const std::vector<TrackPoint>& track, core::Metres hull, core::Metres margin,
               core::Metres rounding = {});

  /// Where it is at a time; between two knots it moves and grows evenly.
  struct Knot {
    double t_s;
    geo::PlanePoint centre;
    double radius_m;  // all included
  };
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
  /// All that it ever covers.
  [[nodiscard]] const plane::PlaneBox& swept() const { return swept_; }
  /// All that it covers from a knot to the next; from the last one on for ever.
  [[nodiscard]] plane::PlaneBox swept_from(std::size_t knot) const;
  /// The hull without allowances at a time: its radius, and metres of the plane per metre on the ground at its place.
  struct Hull {
    double radius_m;
    double scale;
  };
  [[nodiscard]] Hull hull(double t_s) const {
    const double scale = scales_[last_knot_by(t_s)];
    return {scale * hull_m_, scale};
  }
  /// Half the length and the margin.
  [[nodiscard]] double kept_m() const { return kept_m_; }

  /// First moment at which the move is in the disc, grown by `slack_m`; empty: never.
  [[nodiscard]] std::optional<double> first_touch(const motion::EvenMove& move, double slack_m = 0.0) const;
  /// Distance from the point to the rim of the disc, negative inside; empty before the forecast.
  [[nodiscard]] std::optional<double> gap_m(geo::PlanePoint point, double t_s) const;
  /// When the disc, grown by `slack_m`, covers the point: ascending, apart from each other; the last one may never end.
  [[nodiscard]] std::vector<TimeSpan> covers(geo::PlanePoint point, double slack_m = 0.0) const;

  /// Calls `visit(disc)` for the even pieces that last into the span, in order, until it answers true.
  template <class Visit>
  void for_each_piece(double from_s, double until_s, Visit&& visit) const {
    for (std::size_t knot = last_knot_by(from_s); knot < knots_.size() && knots_[knot].t_s <= until_s;
         ++knot) {
      if (visit(piece(knot))) return;
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    return knots_.size() * (sizeof(Knot) + sizeof(double)) + blocks_.size() * sizeof(plane::PlaneBox);
  }

 private:
  [[nodiscard]] motion::MovingDisc piece(std::size_t knot) const;
  /// When it covers the point from a knot to the next; empty: never.
  [[nodiscard]] std::optional<TimeSpan> covers_from(std::size_t knot, geo::PlanePoint point,
                                                    double slack_m) const;
  /// The last knot that is not later; the first one where all are.
  [[nodiscard]] std::size_t last_knot_by(double t_s) const {
    const auto after = std::ranges::upper_bound(knots_, t_s, {}, &Knot::t_s);
    return after == knots_.begin() ? 0 : static_cast<std::size_t>(after - knots_.begin()) - 1;
  }

  double hull_m_;  // on the ground
  double kept_m_;
  plane::PlaneBox swept_;
  std::vector<Knot> knots_;
  std::vector<double> scales_;           // of the plane at each knot
  std::vector<plane::PlaneBox> blocks_;  // what each run of knots covers until the next run begins
};

/// When the vehicle is in a piece of a disc's drift; empty: never. Distance less radius is convex in time, so it is
/// one span.
[[nodiscard]] std::optional<TimeSpan> time_within(const motion::MovingDisc& disc,
                                                  const motion::EvenMove& move);

}  // namespace floeplan::planning::obstacles
