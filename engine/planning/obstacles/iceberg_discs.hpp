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

/// Icebergs as discs to keep out of. Radius: half the length, the margin, and the expected position error up
/// to the limit of the rules. The discs drift and grow. If the rules say so, they stand where the bergs were
/// seen, with the error of the sighting only. After the horizon each stays as it is then. Bergs whose
/// sightings are too old at the epoch are left out.
/// Under    a berg that the vehicle may pass under closes its disc only where the sea is too shallow for
///          that. A berg whose disc ever covers a stop, where the vehicle surfaces, is never passed under
/// Time     counted from `epoch`, the departure
/// Threads  const members may be called from several threads at once
class IcebergDiscs {
 public:
  /// `horizon`: the drift is forecast for this time. `area`: where most questions will be asked; answers
  /// outside are right, too. Once `stop` is requested the discs stay incomplete and must not be
  /// used.
  /// `rounding`: added to the radius that the rules ask for.
  IcebergDiscs(const ocean::Environment& environment, const IcebergRules& rules,
               const geo::LocalProjection& projection, const plane::PlaneBox& area, core::UtcTime epoch,
               core::Seconds horizon, const std::stop_token& stop = {},
               std::optional<PassUnder> pass_under = std::nullopt,
               const std::vector<geo::PlanePoint>& stops = {}, core::Metres rounding = {});

  [[nodiscard]] bool empty() const { return bergs_.empty(); }
  /// Whether no disc ever moves or grows.
  [[nodiscard]] bool standing() const { return standing_; }

  /// Whether a vehicle that travels this piece of the edge touches a disc at any time, not only at samples.
  /// `slack_m`: possible error of the vehicle's places, in metres of the plane. With it no touch is
  /// overlooked.
  [[nodiscard]] bool touched(const motion::PlaneEdge& edge, const motion::EdgePiece& piece,
                             double slack_m) const;
  /// Whether a vehicle that moves at constant speed, or holds, touches a disc.
  [[nodiscard]] bool touched(const motion::EvenMove& move, double slack_m = 0.0) const;
  /// The earliest departure between `depart` and `latest` at which a vehicle that goes straight from one
  /// point to the other at constant speed in `duration` touches no disc; empty if there is none.
  /// Accuracy  some seconds later than the earliest
  [[nodiscard]] std::optional<core::Seconds> first_clear(geo::PlanePoint from, geo::PlanePoint to,
                                                         core::Seconds duration, core::Seconds depart,
                                                         core::Seconds latest) const;
  /// When a disc, grown by `grown` metres of the plane, covers the point: ascending, disjoint; the last span
  /// may be infinite.
  [[nodiscard]] std::vector<TimeSpan> closed_times(geo::PlanePoint point,
                                                   core::Metres grown = core::Metres{0.0}) const;

  /// The iceberg whose disc is nearest to a place. If several discs cover the place, the disc whose rim is
  /// farthest away.
  struct Nearest {
    std::string name;
    core::Metres from_hull;  // distance of the place from the hull, negative inside
    core::Metres kept_off;   // the margin plus the position error that counts at that time
  };
  /// Empty if there are no icebergs.
  [[nodiscard]] std::optional<Nearest> nearest(geo::PlanePoint point, core::Seconds time) const;

  /// The hull (half the length at the forecast place, without margin and error) that a move comes nearest to.
  struct NearestHull {
    std::size_t berg{};
    core::Metres distance;  // on the ground, negative inside
  };
  /// The hull that the move comes nearest to at any of its times; empty without icebergs.
  [[nodiscard]] std::optional<NearestHull> nearest_hull(const motion::EvenMove& move) const;

  /// Expected number of times that a vehicle on this move comes within the margin of a hull, averaged over
  /// the position errors. This is the risk that remains outside the discs, because they do not cover every
  /// error. The whole error counts, not only the part that widens a disc; it is taken as normal and equal in
  /// all directions around the forecast place. A berg that the vehicle passes under is not met during that
  /// time.
  [[nodiscard]] double expected_encounters(const motion::EvenMove& move) const;
  /// Expected encounters per second at a point, for a vehicle of this speed and bergs that stand. The
  /// standard deviation of their positions counts as at least `blur`.
  [[nodiscard]] double encounter_rate(geo::PlanePoint point, core::Seconds time, core::MetresPerSecond speed,
                                      core::Metres blur) const;
  [[nodiscard]] std::size_t size() const { return bergs_.size(); }

  /// Whether the vehicle may pass under some berg.
  [[nodiscard]] bool may_pass_under() const { return may_pass_under_; }
  /// The upper turn that dives need to pass under the bergs above this place and time; empty if there are
  /// none.
  [[nodiscard]] std::optional<core::Metres> least_upper_turn(geo::PlanePoint point, core::Seconds time) const;
  /// A stay of the vehicle in the disc of a berg that it passes under.
  struct Under {
    std::size_t berg{};  // index of the berg, for `keel`
    TimeSpan span;
  };
  /// All stays in discs of icebergs on this move, berg by berg.
  [[nodiscard]] std::vector<Under> passed_under(const motion::EvenMove& move) const;
  [[nodiscard]] const std::string& name(std::size_t berg) const { return bergs_[berg].name; }
  /// Precondition  the vehicle may pass under the berg
  [[nodiscard]] const Keel& keel(std::size_t berg) const { return *bergs_[berg].keel; }

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Berg {
    std::string name;
    DriftingDisc disc;
    PositionError error;
    std::optional<Keel> keel;  // empty: the vehicle must not pass under it
  };
  /// Whether the sea is deep enough to pass under the berg wherever the move is in its disc.
  [[nodiscard]] bool has_room_under(const Berg& berg, const motion::EvenMove& move, double slack_m) const;
  void index(const plane::PlaneBox& area, core::Seconds horizon);
  /// The first berg found whose disc the move touches and must not; null: none.
  [[nodiscard]] const Berg* met_by(const motion::EvenMove& move, double slack_m) const;

  std::vector<Berg> bergs_;
  std::optional<PassUnder> pass_under_;
  bool standing_{true};
  bool may_pass_under_{false};
  double slot_s_{3600.0};
  DiscIndex index_;
};

}  // namespace floeplan::planning::obstacles
