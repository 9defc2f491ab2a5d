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
#include "engine/planning/obstacles/disc_index.hpp"
#include "engine/planning/obstacles/drifting_disc.hpp"
#include "engine/planning/obstacles/expected_encounters.hpp"
#include "engine/planning/obstacles/pass_under.hpp"
#include "engine/planning/problem/iceberg_rules.hpp"
#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::obstacles {

/// Icebergs as discs to keep out of: half the length, the margin, and the expected error of the position up
/// to the most that the rules allow. They drift and grow, or stand where they were seen when the rules say
/// so; a disc that stands has the stated error of its sighting only. After the horizon each stays as it is
/// then. Without those whose sightings are too old for a departure at the epoch.
/// Under    a berg that the vehicle may pass under closes its disc only where the sea is not deep enough for that. One
///          whose disc ever comes over a stop, where the vehicle surfaces, is not passed under
/// Time     counted from `epoch`, the departure
/// Threads  const members may be called from several threads at once
class IcebergDiscs {
 public:
  /// `horizon`: how far ahead the drift is forecast. `area`: where questions will be asked; the answers are right
  /// outside it too. Once `stop` is requested the discs stay incomplete and must not be used.
  /// `rounding`: by which the discs are larger than the rules ask for.
  IcebergDiscs(const ocean::Environment& environment, const IcebergRules& rules,
               const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
               core::Seconds horizon, const std::stop_token& stop = {},
               std::optional<PassUnder> pass_under = std::nullopt,
               const std::vector<geo::PlanePoint>& stops = {}, core::Metres rounding = {});

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
  /// When a disc, grown by so many metres of the plane, covers the point: ascending, apart from each other; the last one
  /// may never end.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point,
                                                   core::Metres grown = core::Metres{0.0}) const;

  /// The iceberg whose disc is nearest to a place, or reaches farthest over it.
  struct Nearest {
    std::string name;
    core::Metres from_hull;  // distance of the place from it, negative inside
    core::Metres kept_off;   // the margin and as much of the position's error as counts then
  };
  /// Empty without icebergs.
  [[nodiscard]] std::optional<Nearest> nearest(geo::PlanePoint point, core::Seconds time) const;

  /// The hull (half the length at the forecast place, without margin and error) that a move comes nearest to.
  struct NearestHull {
    std::size_t berg{};
    core::Metres distance;  // on the ground, negative inside
  };
  /// Over all times of the move; empty without icebergs.
  [[nodiscard]] std::optional<NearestHull> nearest_hull(const motion::EvenMove& move) const;

  /// How often, on the average over the errors of the positions, a vehicle on this move comes within the margin of a
  /// hull: what remains beside the discs, because they do not cover every error. The error counts in full, not only
  /// up to the most that widens a disc, and is taken as normal and alike in all directions about the forecast.
  /// A berg that the vehicle passes under is not met meanwhile.
  [[nodiscard]] double expected_encounters(const motion::EvenMove& move) const;
  /// The same for each second at a point, for a vehicle of this speed among bergs that stand; the positions count as
  /// known no better than to `blur`.
  [[nodiscard]] double encounter_rate(geo::PlanePoint point, core::Seconds time, core::MetresPerSecond speed,
                                      core::Metres blur) const;
  [[nodiscard]] std::size_t size() const { return bergs_.size(); }

  /// Whether the vehicle may pass under any of them.
  [[nodiscard]] bool may_pass_under() const { return may_pass_under_; }
  /// How deep the dives must turn there and then to pass under what is above; empty where nothing is.
  [[nodiscard]] std::optional<core::Metres> least_upper_turn(geo::PlanePoint point, core::Seconds time) const;
  /// A stay of the vehicle in the disc of a berg that it passes under.
  struct Under {
    std::size_t berg{};  // a number of its own
    TimeSpan span;
  };
  /// Each on this move, berg by berg.
  [[nodiscard]] std::vector<Under> passed_under(const motion::EvenMove& move) const;
  [[nodiscard]] const std::string& name(std::size_t berg) const { return bergs_[berg].name; }
  /// Precondition  the berg may be passed under
  [[nodiscard]] const Keel& keel(std::size_t berg) const { return *bergs_[berg].keel; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Berg {
    std::string name;
    DriftingDisc disc;
    PositionError error;
    std::optional<Keel> keel;  // of a berg that may be passed under
  };
  /// Whether the vehicle may pass under the berg wherever the move is in its disc.
  [[nodiscard]] bool has_room_under(const Berg& berg, const motion::EvenMove& move, double slack_m) const;
  void index(const plane::PlaneBox& area, core::Seconds horizon);
  /// The first berg found whose disc the move touches.
  [[nodiscard]] const Berg* met_by(const motion::EvenMove& move, double slack_m) const;

  std::vector<Berg> bergs_;
  std::optional<PassUnder> pass_under_;
  bool standing_{true};
  bool may_pass_under_{false};
  double slot_s_{3600.0};
  DiscIndex index_;
};

}  // namespace floeplan::planning::obstacles
