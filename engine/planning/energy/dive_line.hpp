#pragma once

#include <vector>

#include "engine/planning/obstacles/plane_bed.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::energy {

/// The dives along a straight line of the plane by the sea bed under it: the lower they are, the more often they turn.
/// Accuracy  the bed to a two-hundredth of the dives' thickness: a parabola within each cell of the data that the line
///           comes into, and between looks where these are closer together
/// Threads   const members may be called from several threads at once
class DiveLine {
 public:
  /// `bed` is borrowed for the call; null: as deep as asked everywhere. `look` must be positive then.
  DiveLine(const vehicle::DiveLimits& limits, const obstacles::PlaneBed* bed, core::Metres look,
           geo::PlanePoint a, geo::PlanePoint b);

  /// Whether the dives are the same all along.
  [[nodiscard]] bool is_even() const { return stretches_.size() == 1; }
  /// The band in which a vehicle turns as often as it does on the average from one share of the line to the other, and
  /// so draws as much: pump energy for each metre of depth is the same in all bands of one top but for a part that goes
  /// with the inverse of their thickness. No dive turns above `upper_turn`.
  /// `from` and `until` in [0, 1], not descending.
  [[nodiscard]] vehicle::DiveBand mean_band(double from, double until, core::Metres upper_turn) const;

 private:
  /// Where the lower turn goes straight from one depth to another.
  struct Stretch {
    double until;  // share of the line
    core::Metres first_bottom;
    core::Metres last_bottom;
  };
  /// What no lower turn is above or below.
  struct Bounds {
    core::Metres shoalest;
    core::Metres deepest;
  };
  /// Where the bed alone would have the dives turn at both ends and in the middle of a part of the line.
  struct Bend {
    core::Metres first;
    core::Metres middle;
    core::Metres last;
  };
  /// From one share of the line to another, on a parabola, as the bed is within a cell.
  void add_bend(double from, double until, const Bend& bend, const Bounds& bounds);
  /// The same, straight.
  void add_slope(double from, double until, core::Metres first, core::Metres last, const Bounds& bounds);
  /// One without a length is left out.
  void add_stretch(const Stretch& stretch);
  /// Turns for each metre of depth climbed or dived between two shares of the stretch.
  [[nodiscard]] double turns_m(const Stretch& stretch, double from, double until,
                               core::Metres upper_turn) const;

  core::Metres top_;
  std::vector<Stretch> stretches_;  // one where all are the same
};

}  // namespace floeplan::planning::energy
