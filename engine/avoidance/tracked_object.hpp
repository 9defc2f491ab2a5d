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

/// A patch of surface that the sonar has seen, about `SurfaceCell::size_m` wide and high.
struct SurfaceCell {
  static constexpr double size_m = 6.0;

  geo::PlanePoint offset{};  // from the object's origin
  double depth_m{};
  double deepest_m{};  // greatest depth from which all its echoes can come
  double seen_s{};     // last time, on the clock of the flight
  std::uint16_t hits{};
  bool beside_other{};  // another cell is at the same place in the plane
};

/// A body as seen by the sonar so far: its surface and its motion.
/// Frame    water; the surface is fixed to the origin, which moves with the estimated drift
/// Filter   A Kalman filter for the origin's place and drift. Each echo on a known part of the surface
///          measures the surface's displacement along its normal (of the line through the cells around it);
///          along a straight wall nothing is measured. The drift is a random walk of 0.01 m/s in 100 s, for
///          rotating bergs and sheared currents
/// Memory   fixed; when full, the cell farthest from the vehicle is dropped
/// Source   point-to-line registration: Censi 2008, doi:10.1109/ROBOT.2008.4543181; Kalman 1960
class TrackedObject {
 public:
  static constexpr std::size_t most_cells = 192;

  TrackedObject() = default;
  TrackedObject(std::uint32_t id, const Echo& first, double now_s, core::MetresPerSecond drift_sigma);

  void advance(double now_s);

  /// Position of an echo relative to the surface seen so far.
  enum class Match : std::uint8_t { none, near_by, on_surface };
  /// Matches an echo. On the surface it refreshes the surface and is stored for `correct`.
  Match take(const Echo& echo, const SonarView& sonar);
  /// Corrects place and drift by the echoes on the surface since the last call.
  void correct();
  /// Adds a patch of surface that has been confirmed.
  void add(const Echo& confirmed, geo::PlanePoint vehicle);
  void forget_before(double seen_s);
  /// Handles an echo behind a cell: a cell that the sonar sees through does not exist, or no longer.
  void contradict(const Echo& echo, geo::PlanePoint vehicle, double vehicle_depth_m);

  [[nodiscard]] std::uint32_t id() const { return id_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const SurfaceCell& cell(std::size_t i) const { return cells_[i]; }
  [[nodiscard]] geo::PlanePoint place(const SurfaceCell& cell) const {
    return {state_[0] + cell.offset.x_m, state_[1] + cell.offset.y_m};
  }
  [[nodiscard]] geo::PlaneVelocity drift() const { return {state_[2], state_[3]}; }
  [[nodiscard]] double place_sigma_m() const;  // standard deviation in the worse direction
  [[nodiscard]] double drift_sigma_m_s() const;
  /// Centre of the smallest box around the cells in the plane.
  [[nodiscard]] geo::PlanePoint centre() const;
  [[nodiscard]] double half_extent_m() const;              // half the diagonal of that box
  [[nodiscard]] double keel_m() const { return keel_m_; }  // depth of the lowest cell
  [[nodiscard]] double top_m() const { return top_m_; }    // depth of the highest cell
  [[nodiscard]] double seen_s() const { return seen_s_; }
  /// Number of consecutive pings that looked below the keel and found nothing.
  [[nodiscard]] int looks_below() const { return looks_below_; }
  /// `lowest_look_m`: depth down to which the sonar would have seen the object's side.
  void look_below(double lowest_look_m);
  /// Resets the looks below if the sea bed's echo lies directly under the keel.
  void stand_on(const Echo& bed);
  /// Number of consecutive pings with beams above the top that found nothing.
  [[nodiscard]] int looks_above() const { return looks_above_; }
  /// Counts a ping that found nothing above the top, if the top is deeper than `least_top_m`: only then did a
  /// row of beams look above it. Otherwise the count begins again at zero.
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
  geo::PlanePoint low_{};  // corners of the box, relative to the origin
  geo::PlanePoint high_{};

  // Sums over the echoes since the last correction: of n n^T / sigma^2 and of n r / sigma^2 (n: normal, r:
  // residual).
  std::array<double, 3> information_{};
  std::array<double, 2> pull_{};
  int echoes_{};
};

}  // namespace floeplan::avoidance
