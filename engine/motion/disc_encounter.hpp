#pragma once

#include <optional>

#include "engine/geo/local_projection.hpp"
#include "engine/motion/edge_time.hpp"

namespace floeplan::motion {

/// A disc whose centre moves straight and evenly and whose radius changes evenly, from t0 to t1.
/// Units    metres of the plane; seconds on the clock of the departure; t1 may be infinite when nothing changes
struct MovingDisc {
  double t0_s{};
  double t1_s{};
  geo::PlanePoint centre0;
  geo::PlaneVelocity velocity;
  double radius0_m{};
  double growth_m_s{};
};

/// A vehicle that moves straight and evenly from one place and time to another. Precondition: it takes time,
/// or both places are the same.
struct EvenMove {
  geo::PlanePoint from;
  geo::PlanePoint to;
  double t0_s{};
  double t1_s{};
};

/// Where the vehicle is at a time of the move.
[[nodiscard]] geo::PlanePoint place_at(const EvenMove& move, double t_s);

/// First moment at which the vehicle is in the disc (on its rim included), while both exist; empty: never.
/// Exact: the roots of |p(t) - c(t)|^2 = r(t)^2, not samples.
[[nodiscard]] std::optional<double> first_touch(const EvenMove& move, const MovingDisc& disc);

/// Least distance of the vehicle from the centre of the disc while both exist; empty: they never do.
[[nodiscard]] std::optional<double> least_distance(const EvenMove& move, const MovingDisc& disc);

/// A part of a drive along an edge, taken as an even move, and how far the vehicle may be from it at most.
struct ChordOfPiece {
  EvenMove move;
  double deviation_m{};  // metres of the plane, along the edge
};

/// The chord of the piece's cubic s(t), within |s''| h^2 / 8 of it.
[[nodiscard]] ChordOfPiece chord_of(const PlaneEdge& edge, const EdgePiece& piece);

/// The two halves of a piece, each the same cubic.
struct HalvedPiece {
  EdgePiece first;
  EdgePiece second;
};
[[nodiscard]] HalvedPiece halve(const EdgePiece& piece);

/// Calls `visit(move, deviation_m)` for even moves that follow the piece one after the other, each within
/// `most_deviation_m` of it; precondition: the edge has a length. Ends with the first answer of `visit` that is not
/// empty, and returns it.
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
