#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/motion/disc_encounter.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/disc_index.hpp"
#include "engine/planning/iceberg_rules.hpp"
#include "engine/planning/time_span.hpp"

namespace floeplan::planning {

/// Icebergs as discs to keep out of: half the length, the margin, and the expected error of the position up to the
/// most that the rules allow. They drift and grow, or stand where they were seen when the rules say so; a disc
/// that stands has the stated error of its sighting only. After the horizon each stays as it is then.
/// Time     counted from `epoch`, the departure
/// Threads  const members may be called from several threads at once
class IcebergDiscs {
 public:
  /// `horizon`: how far ahead the drift is forecast. `area`: where questions will be asked; the answers are right
  /// outside it too. Once `stop` is requested the discs stay incomplete and must not be used.
  IcebergDiscs(const ocean::Environment& environment, const IcebergRules& rules,
               const geo::LocalProjection& projection, const PlaneBox& area, core::UtcTime epoch,
               core::Seconds horizon, const std::stop_token& stop = {});

  [[nodiscard]] bool empty() const { return bergs_.empty(); }
  /// Whether no disc ever moves or grows.
  [[nodiscard]] bool standing() const { return standing_; }

  /// Whether a vehicle that drives this piece of the edge touches a disc, tested between all samples.
  /// `slack_m`: metres of the plane by which the drive itself may be in error; never overlooks a touch.
  [[nodiscard]] bool touched(const motion::PlaneEdge& edge, const motion::EdgePiece& piece,
                             double slack_m) const;
  /// Whether a vehicle that moves evenly, or waits, touches a disc.
  [[nodiscard]] bool touched(const motion::EvenMove& move, double slack_m = 0.0) const;
  /// The earliest departure, from `depart` on and no later than `latest`, for which a vehicle that goes straight and
  /// evenly from one point to the other in this time touches no disc; empty: there is none.
  /// Accuracy  some seconds later than the earliest
  [[nodiscard]] std::optional<core::Seconds> first_clear(geo::PlanePoint from, geo::PlanePoint to,
                                                         core::Seconds duration, core::Seconds depart,
                                                         core::Seconds latest) const;
  /// When a disc covers the point: ascending, apart from each other; the last one may never end.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point) const;

  /// The iceberg whose disc is nearest to a place, or reaches farthest over it.
  struct Nearest {
    std::string name;
    core::Metres from_hull;  // distance of the place from it, negative inside
    core::Metres kept_off;   // the margin and as much of the position's error as counts then
  };
  /// Empty without icebergs.
  [[nodiscard]] std::optional<Nearest> nearest(geo::PlanePoint point, core::Seconds time) const;

  /// Least distance on the ground, over all times of the move, from any hull (half the length at the forecast
  /// place, without margin and error), negative inside; empty without icebergs.
  [[nodiscard]] std::optional<core::Metres> distance_from_hulls(const motion::EvenMove& move) const;

  /// How often, on the average over the errors of the positions, a vehicle on this move comes within the margin of a
  /// hull: what remains beside the discs, because they do not cover every error. The error counts in full, not only
  /// up to the most that widens a disc, and is taken as normal and alike in all directions about the forecast.
  [[nodiscard]] double expected_encounters(const motion::EvenMove& move) const;

 private:
  /// Where a disc is at a time; between two knots it moves and grows evenly.
  struct Knot {
    double t_s;
    geo::PlanePoint centre;
    double radius_m;  // of the plane, all included
  };
  struct Berg {
    std::string name;
    double hull_radius_m;  // of the plane, half the length
    double kept_m;         // of the plane: half the length and the margin
    double scale;
    core::Metres stated_error;
    double sighted_s;
    PlaneBox swept;  // all that its disc ever covers
    std::vector<Knot> knots;
  };
  [[nodiscard]] static motion::MovingDisc disc(const Berg& berg, std::size_t knot, double slack_m);
  template <class Visit>
  static void for_each_disc(const Berg& berg, double from_s, double until_s, double slack_m, Visit&& visit);
  [[nodiscard]] static std::optional<double> touch(const Berg& berg, const motion::EvenMove& move,
                                                   double slack_m);
  void index(const PlaneBox& area, core::Seconds horizon);
  /// The first berg found whose disc the move touches.
  [[nodiscard]] const Berg* met_by(const motion::EvenMove& move, double slack_m) const;

  [[nodiscard]] double mean_error_m(const Berg& berg, double t_s) const;

  std::vector<Berg> bergs_;
  bool standing_{true};
  double slot_s_{3600.0};
  DiscIndex index_;
};

}  // namespace floeplan::planning
