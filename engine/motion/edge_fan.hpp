#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geo/local_projection.hpp"

namespace floeplan::motion {

/// The straight edges out of a point, one in each lane (for vector instructions).
struct EdgeFan {
  static constexpr std::size_t most = 80;   // edges out of a vertex of a 5-sector grid
  static constexpr std::size_t block = 16;  // lanes per group: floats in the widest register

  std::size_t lanes{};                        // a multiple of `block`; surplus lanes repeat the last edge
  alignas(64) std::array<float, most> x_m{};  // from the point to the edge's end, metres of the plane
  alignas(64) std::array<float, most> y_m{};
  alignas(64) std::array<float, most> length_m{};  // metres of the plane
  alignas(64) std::array<float, most> ex{};        // unit vector of the edge
  alignas(64) std::array<float, most> ey{};

  EdgeFan() = default;
  /// Errors   std::invalid_argument for no edge, more than `most` or one without length
  explicit EdgeFan(const std::vector<geo::PlanePoint>& edges);
};

/// Model of the current around a point from a time on, as far as edges reach.
/// Model    At the point the current is linear between knots of time. Elsewhere it is the point's current
///          plus a change per metre. The change lies in a box, given by centre and half widths along two axes
///          u and v. Each of the four quarters between the axes has its own box, for the edges that lead into
///          it
struct NearbyCurrent {
  static constexpr std::size_t most_knots = 32;
  static constexpr std::size_t quarters = 4;
  using ByQuarter = std::array<float, quarters>;

  /// Index of the quarter of the plane into which an edge leads. `down_u`, `down_v`: it leads down this axis.
  static constexpr std::size_t quarter(bool down_u, bool down_v) {
    return (down_u ? 1U : 0U) + (down_v ? 2U : 0U);
  }

  float x_m_s{};  // current at the point, at the beginning
  float y_m_s{};
  float x_m_s2{};  // its slope in time, up to the first knot
  float y_m_s2{};
  std::size_t knots{};
  std::array<float, most_knots> knot_s{};  // times of the knots after the beginning, ascending
  std::array<float, most_knots> bend_x{};  // change of the slope at each knot
  std::array<float, most_knots> bend_y{};
  float steepest_m_s2{};  // largest slope in time until `known_s`
  float known_s{};        // the model is valid for this time

  float u_x{};  // axes u and v, per metre of the plane
  float u_y{};
  float v_x{};
  float v_y{};
  ByQuarter x_by_u{};  // centre of the change per unit of u and v
  ByQuarter y_by_u{};
  ByQuarter x_by_v{};
  ByQuarter y_by_v{};
  ByQuarter off_by_u{};  // bound of the deviation from the centre, as a vector's length
  ByQuarter off_by_v{};
  float unseen_m_s{};  // error of the model itself
};

/// The vehicle for which a fan is timed.
struct FanVehicle {
  float through_water_m_s{};
  float ground_per_plane{
      1.0F};          // metres on the ground per metre of the plane: a lower bound that holds for all edges
  float longest_s{};  // longer durations are all given as this
  bool never_stopped{false};  // no current in the data closes any course for it
};

/// Seconds by lane.
struct alignas(64) FanTimes {
  std::array<float, EdgeFan::most> time_s;
};

/// Ways to compute the lanes; all give identical bits.
enum class FanPath {
  reference,  // one lane after another, as the formulas are written
  baseline,   // instructions of every x86-64
  avx2,
  avx512
};

/// The paths that this processor supports, the widest last.
[[nodiscard]] const std::vector<FanPath>& fan_paths();

/// Estimated time of each edge for a vehicle that leaves now, from the mean current of a straight drive at
/// constant speed.
/// `longest_s` if it takes longer or is closed.
void estimate_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle,
                  FanTimes& times, FanPath path = fan_paths().back());

/// Lower bounds of the travel time of each edge, for every vehicle that leaves the point now and stays on the
/// edge, in any current that the model allows. Zero if the model does not prove that the edge is passable:
/// without FIFO a later departure could then arrive sooner.
/// Method   Let c be the mean over time of the current that the vehicle meets. Its mean speed over ground
///          along the edge's direction e is at most g(c, V) = c.e + sqrt(V^2 - (c.n)^2), because the pairs of
///          a speed s and a current c with |s e - c| <= V form a convex set. If c is known as c0 with error
///          r, then |s e - c0| <= V + r, so the speed is at most g(c0, V + r). The mean c is enclosed from:
///          its course over time at the point, half the change over the edge, and for both the effect of a
///          drive that is not at constant speed
/// Accuracy too short by some hundredths in tides and eddies on edges of a few kilometres, depending on how
/// slopes differ
void bound_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle, FanTimes& times,
               FanPath path = fan_paths().back());

/// From now on fan_paths() ends with this path in the whole process, as on a processor without wider ones. So
/// tests can show that plans do not depend on the path.
/// Errors   std::invalid_argument for a path that this processor does not support
/// Threads  call before any planning
void limit_fan_paths(FanPath widest);

}  // namespace floeplan::motion
