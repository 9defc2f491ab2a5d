#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/avoidance/echo.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"

namespace floeplan::avoidance {

/// A patch of a surface that the sonar has seen, about `SurfaceCell::size_m` wide and high.
struct SurfaceCell {
  static constexpr double size_m = 6.0;

  geo::PlanePoint offset{};  // from the object's origin
  double depth_m{};
  double deepest_m{};  // the greatest depth from which all its echoes can have come
  double seen_s{};     // when last, on the clock of the flight
  std::uint16_t hits{};
  bool beside_other{};  // seen from above another cell lies there already
};

/// A body as far as the sonar has seen it: its surface, and how it moves.
/// Frame    water; the surface is fixed to the origin, which moves with the estimated drift
/// Filter   Kalman's on the origin's place and drift. Each echo on a known part of the surface says how far the surface
///          has moved along its normal (the line through the cells around it); along a straight wall nothing is learnt.
///          The drift is a random walk of 0.01 m/s in 100 s: what turning bergs and sheared water do to it
/// Memory   fixed; when full the cell farthest from the vehicle gives way
/// Source   point-to-line registration: Censi 2008, doi:10.1109/ROBOT.2008.4543181; Kalman 1960
class TrackedObject {
 public:
  static constexpr std::size_t most_cells = 192;

  TrackedObject() = default;
  TrackedObject(std::uint32_t id, const Echo& first, double now_s, core::MetresPerSecond drift_sigma);

  void advance(double now_s);

  /// How near the echo is to the surface seen so far.
  enum class Match : std::uint8_t { none, near_by, on_surface };
  /// An echo on the surface refreshes it and is remembered for `correct`.
  Match take(const Echo& echo, const SonarView& sonar);
  /// Corrects place and drift by the echoes that were on the surface since the last time.
  void correct();
  /// Adds a patch of surface that has been confirmed.
  void add(const Echo& confirmed, geo::PlanePoint vehicle);
  void forget_before(double seen_s);
  /// Whether the sonar looks past a cell at something behind it: such a cell was never there, or is not any more.
  void contradict(const Echo& echo, geo::PlanePoint vehicle, double vehicle_depth_m);

  [[nodiscard]] std::uint32_t id() const { return id_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const SurfaceCell& cell(std::size_t i) const { return cells_[i]; }
  [[nodiscard]] geo::PlanePoint place(const SurfaceCell& cell) const {
    return {state_[0] + cell.offset.x_m, state_[1] + cell.offset.y_m};
  }
  [[nodiscard]] geo::PlaneVelocity drift() const { return {state_[2], state_[3]}; }
  [[nodiscard]] double place_sigma_m() const;  // of the worse direction
  [[nodiscard]] double drift_sigma_m_s() const;
  /// The smallest box round the cells, seen from above.
  [[nodiscard]] geo::PlanePoint centre() const;
  [[nodiscard]] double half_extent_m() const;              // half its diagonal
  [[nodiscard]] double keel_m() const { return keel_m_; }  // depth of the lowest cell
  [[nodiscard]] double top_m() const { return top_m_; }    // of the highest
  [[nodiscard]] double seen_s() const { return seen_s_; }
  /// Pings in a row that looked below the keel and met nothing.
  [[nodiscard]] int looks_below() const { return looks_below_; }
  /// `lowest_look_m`: how deep the sonar would have seen the object's side.
  void look_below(double lowest_look_m);
  /// Nothing was looked below where an echo of the sea bed lies under the keel without a gap.
  void stand_on(const Echo& bed);
  /// Pings in a row in which beams looked over the top and met nothing.
  [[nodiscard]] int looks_above() const { return looks_above_; }
  /// `least_top_m`: a top deeper than that had a row of beams above it.
  void look_above(double least_top_m);

 private:
  void measure_box();
  void remove(std::size_t i);

  std::uint32_t id_{};
  std::size_t size_{};
  std::array<SurfaceCell, most_cells> cells_{};
  std::array<double, 4> state_{};  // place east and north, drift east and north
  std::array<std::array<double, 4>, 4> covariance_{};
  double now_s_{};
  double seen_s_{};
  double keel_m_{};
  double top_m_{};
  int looks_below_{};
  int looks_above_{};
  geo::PlanePoint low_{};  // corners of the box, from the origin
  geo::PlanePoint high_{};

  // Sums over the echoes since the last correction: of n n^T / sigma^2 and of n r / sigma^2.
  std::array<double, 3> information_{};
  std::array<double, 2> pull_{};
  int echoes_{};
};

}  // namespace floeplan::avoidance
