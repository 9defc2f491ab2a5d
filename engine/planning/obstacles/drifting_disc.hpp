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

/// The disc around one iceberg that a vehicle must keep out of, as it drifts and grows. Radius: half the
/// berg's length, the margin and the position error. After the end of the forecast the disc stays as it is
/// then.
/// Units    metres of the plane; times count from the epoch of the forecast
/// Threads  const members may be called from several threads at once
class DriftingDisc {
 public:
  /// `track` has at least one point. `hull`: half the length, on the ground. `rounding`: added to the radius,
  /// but in no figure that is shown.
  DriftingDisc(const std::vector<TrackPoint>& track, core::Metres hull, core::Metres margin,
               core::Metres rounding = {});

  /// The disc at one time. Between two knots it moves and grows at a constant rate.
  struct Knot {
    double t_s;
    geo::PlanePoint centre;
    double radius_m;  // with all allowances
  };
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
  /// Box around everything that the disc ever covers.
  [[nodiscard]] const plane::PlaneBox& swept() const { return swept_; }
  /// Box around the area that the disc covers from one knot to the next. For the last knot: from then on, without
  /// end.
  [[nodiscard]] plane::PlaneBox swept_from(std::size_t knot) const;
  /// The hull without allowances at one time. `scale`: metres of the plane per metre on the ground at its
  /// place.
  struct Hull {
    double radius_m;
    double scale;
  };
  [[nodiscard]] Hull hull(double t_s) const {
    const double scale = scales_[last_knot_by(t_s)];
    return {scale * hull_m_, scale};
  }
  /// Half the length plus the margin, in metres of the plane.
  [[nodiscard]] double kept_m() const { return kept_m_; }

  /// The first time in seconds at which the move is in the disc grown by `slack_m`; empty: never.
  [[nodiscard]] std::optional<double> first_touch(const motion::EvenMove& move, double slack_m = 0.0) const;
  /// Distance from the point to the rim of the disc, negative inside; empty before the forecast begins.
  [[nodiscard]] std::optional<double> gap_m(geo::PlanePoint point, double t_s) const;
  /// When the disc grown by `slack_m` covers the point: ascending, disjoint; the last span may be infinite.
  [[nodiscard]] std::vector<TimeSpan> covers(geo::PlanePoint point, double slack_m = 0.0) const;

  /// Calls `visit(disc)` for the pieces of constant drift that overlap the span, in order, until it returns
  /// true.
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
  /// The span within a knot's piece in which the disc covers the point; empty: never.
  [[nodiscard]] std::optional<TimeSpan> covers_from(std::size_t knot, geo::PlanePoint point,
                                                    double slack_m) const;
  /// The last knot at or before the time; the first knot if all are later.
  [[nodiscard]] std::size_t last_knot_by(double t_s) const {
    const auto after = std::ranges::upper_bound(knots_, t_s, {}, &Knot::t_s);
    return after == knots_.begin() ? 0 : static_cast<std::size_t>(after - knots_.begin()) - 1;
  }

  double hull_m_;  // on the ground
  double kept_m_;
  plane::PlaneBox swept_;
  std::vector<Knot> knots_;
  std::vector<double> scales_;           // scale of the plane at each knot
  std::vector<plane::PlaneBox> blocks_;  // box around each run of knots, up to the beginning of the next run
};

/// When the moving vehicle is inside one piece of a disc's drift; empty: never. Distance minus radius is
/// convex in time, so it is a single span.
[[nodiscard]] std::optional<TimeSpan> time_within(const motion::MovingDisc& disc,
                                                  const motion::EvenMove& move);

}  // namespace floeplan::planning::obstacles
