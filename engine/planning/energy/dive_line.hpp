#pragma once

#include <vector>

#include "engine/planning/obstacles/plane_bed.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::planning::energy {

/// The dives along a straight line of the plane over the sea bed. Where the water is shallower, they turn more often.
/// Accuracy  the depth of the bed is exact to 1/200 of the height of the dives. It is taken as a parabola within each cell
///           of the data that the line crosses, or between two samples where these are closer together
/// Threads   const members may be called from several threads at once
class DiveLine {
 public:
  /// `bed` is borrowed for the call; null: deep water everywhere. `look` is the distance between samples, positive.
  DiveLine(const vehicle::DiveLimits& limits, const obstacles::PlaneBed* bed, core::Metres look,
           geo::PlanePoint a, geo::PlanePoint b);

  /// Whether all dives along the line are equal.
  [[nodiscard]] bool is_even() const { return stretches_.size() == 1; }
  /// One band of depths that stands for all dives between two shares of the line: a vehicle that dives in this band turns
  /// as often, so it uses the same energy. (The pump energy per metre of depth has a constant part and a part for each
  /// turn.) No dive turns above `upper_turn`.
  /// `from` and `until` in [0, 1], not descending.
  [[nodiscard]] vehicle::DiveBand mean_band(double from, double until, core::Metres upper_turn) const;

 private:
  /// A part of the line where the lower turn changes evenly from one depth to another.
  struct Stretch {
    double until;  // share of the line
    core::Metres first_bottom;
    core::Metres last_bottom;
  };
  /// The limits of all lower turns.
  struct Bounds {
    core::Metres shoalest;
    core::Metres deepest;
  };
  /// The depths at which the sea bed alone would turn the dives, at both ends and in the middle of a part of the line.
  struct Bend {
    core::Metres first;
    core::Metres middle;
    core::Metres last;
  };
  /// Adds a part between two shares of the line, on a parabola: the shape of the bed within a cell.
  void add_bend(double from, double until, const Bend& bend, const Bounds& bounds);
  /// Adds a part of the line between two shares, with a straight slope of the lower turn from `first` to
  /// `last`.
  void add_slope(double from, double until, core::Metres first, core::Metres last, const Bounds& bounds);
  /// Adds a stretch, unless its length is zero.
  void add_stretch(const Stretch& stretch);
  /// Turns per metre of depth between two shares of the stretch.
  [[nodiscard]] double turns_m(const Stretch& stretch, double from, double until,
                               core::Metres upper_turn) const;

  core::Metres top_;
  std::vector<Stretch> stretches_;  // a single one where all dives are the same
};

}  // namespace floeplan::planning::energy
