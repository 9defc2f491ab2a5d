#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/geo/local_projection.hpp"

namespace floeplan::motion {

/// The straight edges that leave a point, one in each lane.
struct EdgeFan {
  static constexpr std::size_t most = 80;   // edges out of a vertex of a 5-sector grid
  static constexpr std::size_t block = 16;  // lanes are worked in such groups, the widest register of floats

  std::size_t lanes{};  // a multiple of `block`; those beyond the edges repeat the last one
  alignas(64) std::array<float, most> x_m{};  // of the plane, from the point to the edge's end
  alignas(64) std::array<float, most> y_m{};
  alignas(64) std::array<float, most> length_m{};  // of the plane
  alignas(64) std::array<float, most> ex{};        // unit direction
  alignas(64) std::array<float, most> ey{};

  EdgeFan() = default;
  /// Errors   std::invalid_argument for no edge, more than `most` or one without length
  explicit EdgeFan(const std::vector<geo::PlanePoint>& edges);
};

/// The current about a point from a time on, as far as edges reach that leave it.
/// Model    at the point: linear between knots of time. Elsewhere: the point's own current at that time and a
///          change for each metre that lies in a box, given by its centre and half widths along two axes u and v; a box
///          for each of the quarters between them, for edges into that quarter
struct NearbyCurrent {
  static constexpr std::size_t most_knots = 32;
  static constexpr std::size_t quarters = 4;
  using ByQuarter = std::array<float, quarters>;

  /// Which quarter an edge goes into, by whether it goes down each axis.
  static constexpr std::size_t quarter(bool down_u, bool down_v) {
    return (down_u ? 1U : 0U) + (down_v ? 2U : 0U);
  }

  float x_m_s{};  // at the point at the beginning
  float y_m_s{};
  float x_m_s2{};  // its first slope in time
  float y_m_s2{};
  std::size_t knots{};
  std::array<float, most_knots> knot_s{};  // after the beginning, ascending
  std::array<float, most_knots> bend_x{};  // by which the slope changes there
  std::array<float, most_knots> bend_y{};
  float steepest_m_s2{};  // the greatest slope in time until `known_s`
  float known_s{};        // so long the model holds

  float u_x{};  // of the plane's metres: the axes u and v
  float u_y{};
  float v_x{};
  float v_y{};
  ByQuarter x_by_u{};  // centre of the change for each unit of u and v
  ByQuarter y_by_u{};
  ByQuarter x_by_v{};
  ByQuarter y_by_v{};
  ByQuarter off_by_u{};  // how much the change may differ from it, a bound on the vector's length
  ByQuarter off_by_v{};
  float unseen_m_s{};  // what the model itself may miss
};

/// What a fan is timed with.
struct FanVehicle {
  float through_water_m_s{};
  float ground_per_plane{
      1.0F};                  // metres on the ground for one of the plane, never more than it is on any edge
  float longest_s{};          // durations beyond it need not be told apart
  bool never_stopped{false};  // no current that there is anywhere keeps it from any course
};

/// Seconds by lane.
struct alignas(64) FanTimes {
  std::array<float, EdgeFan::most> time_s;
};

/// How the lanes are worked; all give the same bits.
enum class FanPath {
  reference,  // one lane after the other, as the formulas are read
  baseline,   // what every x86-64 has
  avx2,
  avx512
};

/// The paths that this processor can take, the widest last.
[[nodiscard]] const std::vector<FanPath>& fan_paths();

/// About how long each edge takes for a vehicle that leaves now: the chord's mean current for the whole edge.
/// `longest_s` where it takes longer or is closed.
void estimate_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle,
                  FanTimes& times, FanPath path = fan_paths().back());

/// Never more than the travel time of any vehicle that leaves the point now and keeps to the edge, in any current
/// that the model allows; zero where the model does not prove that the edge is passable, for then one that leaves
/// at another time may be sooner there than travel times of passable edges allow.
/// Method   With c the mean over time of the current that the vehicle meets, its speed over ground on the edge's
///          direction e is on the average no more than g(c, V) = c.e + sqrt(V^2 - (c.n)^2): the pairs of a speed s
///          and a current c with |s e - c| <= V are a convex set. Where c is known to within r,
///          |s e - c0| <= V + r: no more than g(c0, V + r). What is left is to enclose the mean: over time at the
///          point, half the change over the edge, and for each of both by how much the vehicle's way may differ
///          from an even one.
/// Accuracy short by some hundredths in tides and eddies on edges of a few kilometres: by how the slopes differ
void bound_fan(const EdgeFan& fan, const NearbyCurrent& current, const FanVehicle& vehicle, FanTimes& times,
               FanPath path = fan_paths().back());

/// From now on and in the whole process fan_paths() ends with this path, as on a processor that has no wider one: so it
/// can be shown that plans do not depend on it.
/// Errors   std::invalid_argument for a path that this processor cannot take
/// Threads  to be called before anything is planned
void limit_fan_paths(FanPath widest);

}  // namespace floeplan::motion
