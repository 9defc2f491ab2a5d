#pragma once

#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_time.hpp"

namespace floeplan::motion {

/// A disc whose centre moves at constant velocity and whose radius changes at a constant rate, from t0 to t1.
/// Units    metres of the plane; seconds on the clock of the departure; t1 may be infinite if nothing changes
struct MovingDisc {
  double t0_s{};
  double t1_s{};
  geo::PlanePoint centre0;
  geo::PlaneVelocity velocity;
  double radius0_m{};
  double growth_m_s{};
};

/// A vehicle that moves from one place to another on a straight line at constant speed. Precondition: the
/// duration is positive, or both places are the same.
struct EvenMove {
  geo::PlanePoint from;
  geo::PlanePoint to;
  double t0_s{};
  double t1_s{};
};

/// Place of the vehicle at a time during the move.
[[nodiscard]] geo::PlanePoint place_at(const EvenMove& move, double t_s);

/// First time at which the vehicle is in the disc or on its rim, while both exist; empty: never. Exact: from
/// the roots of |p(t) - c(t)|^2 = r(t)^2, not from samples.
[[nodiscard]] std::optional<double> first_touch(const EvenMove& move, const MovingDisc& disc);

/// Least distance of the vehicle from the centre of the disc while both exist; empty: they never both exist.
[[nodiscard]] std::optional<double> least_distance(const EvenMove& move, const MovingDisc& disc);

/// A move at constant speed that approximates a piece of a drive, and the largest distance of the vehicle
/// from it.
struct ChordOfPiece {
  EvenMove move;
  double deviation_m{};  // along the edge, in metres of the plane
};

/// The chord of the piece's cubic s(t). Its deviation is at most |s''| h^2 / 8 for a duration h.
[[nodiscard]] ChordOfPiece chord_of(const PlaneEdge& edge, const EdgePiece& piece);

/// The two halves of a piece; both follow the same cubic.
struct HalvedPiece {
  EdgePiece first;
  EdgePiece second;
};
[[nodiscard]] HalvedPiece halve(const EdgePiece& piece);

/// Calls `visit(move, deviation_m)` for consecutive moves at constant speed that follow the piece within
/// `most_deviation_m`.
/// Precondition: the edge has a length. Ends at the first non-empty result of `visit`, and returns it.
template <class Visit>
auto follow_piece(const PlaneEdge& edge, const EdgePiece& piece, double most_deviation_m, Visit&& visit)
    -> decltype(visit(EvenMove{}, 0.0)) {
  const ChordOfPiece chord = chord_of(edge, piece);
  if (!(chord.deviation_m > most_deviation_m)) return visit(chord.move, chord.deviation_m);
  const HalvedPiece halves = halve(piece);
  if (auto answer = follow_piece(edge, halves.first, most_deviation_m, visit)) return answer;
  return follow_piece(edge, halves.second, most_deviation_m, visit);
}

}  // namespace floeplan::motion
