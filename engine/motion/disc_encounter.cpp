#include "engine/motion/disc_encounter.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::motion {
namespace {

/// Place of the vehicle relative to the disc's centre while both exist: q(t) = from + (t - t0) * velocity.
struct Relative {
  double t0_s;
  double duration_s;
  geo::PlanePoint from;
  geo::PlaneVelocity velocity;
};

std::optional<Relative> seen_from(const MovingDisc& disc, const EvenMove& move) {
  const double t0 = std::max(move.t0_s, disc.t0_s);
  const double t1 = std::min(move.t1_s, disc.t1_s);
  if (t0 > t1) return std::nullopt;
  const double duration = move.t1_s - move.t0_s;
  const geo::PlaneVelocity v = duration > 0.0 ? geo::PlaneVelocity{(move.to.x_m - move.from.x_m) / duration,
                                                                   (move.to.y_m - move.from.y_m) / duration}
                                              : geo::PlaneVelocity{};
  const double since_move = t0 - move.t0_s;
  const double since_disc = t0 - disc.t0_s;
  return Relative{
      t0,
      t1 - t0,
      {move.from.x_m + since_move * v.x_m_s - disc.centre0.x_m - since_disc * disc.velocity.x_m_s,
       move.from.y_m + since_move * v.y_m_s - disc.centre0.y_m - since_disc * disc.velocity.y_m_s},
      {v.x_m_s - disc.velocity.x_m_s, v.y_m_s - disc.velocity.y_m_s}};
}

}  // namespace

geo::PlanePoint place_at(const EvenMove& move, double t_s) {
  const double duration = move.t1_s - move.t0_s;
  const double share = duration > 0.0 ? (t_s - move.t0_s) / duration : 0.0;
  return {move.from.x_m + share * (move.to.x_m - move.from.x_m),
          move.from.y_m + share * (move.to.y_m - move.from.y_m)};
}

std::optional<double> first_touch(const EvenMove& move, const MovingDisc& disc) {
  const auto q = seen_from(disc, move);
  if (!q) return std::nullopt;
  // Solves |q|^2 - r^2 = a t^2 + 2 b t + c <= 0.
  const double r = disc.radius0_m + (q->t0_s - disc.t0_s) * disc.growth_m_s;
  const double c = q->from.x_m * q->from.x_m + q->from.y_m * q->from.y_m - r * r;
  if (c <= 0.0) return q->t0_s;
  const double b = q->from.x_m * q->velocity.x_m_s + q->from.y_m * q->velocity.y_m_s - r * disc.growth_m_s;
  const double a = q->velocity.x_m_s * q->velocity.x_m_s + q->velocity.y_m_s * q->velocity.y_m_s -
                   disc.growth_m_s * disc.growth_m_s;
  // The vehicle begins outside. First root, in the form without cancellation; none if the distance only
  // grows.
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || (b >= 0.0 && a >= 0.0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double t = b < 0.0 ? c / (-b + root) : (-b - root) / a;
  if (!(t >= 0.0 && t <= q->duration_s)) return std::nullopt;
  return q->t0_s + t;
}

std::optional<double> least_distance(const EvenMove& move, const MovingDisc& disc) {
  const auto q = seen_from(disc, move);
  if (!q) return std::nullopt;
  const double v2 = q->velocity.x_m_s * q->velocity.x_m_s + q->velocity.y_m_s * q->velocity.y_m_s;
  const double b = q->from.x_m * q->velocity.x_m_s + q->from.y_m * q->velocity.y_m_s;
  const double t = v2 > 0.0 ? std::clamp(-b / v2, 0.0, q->duration_s) : 0.0;
  return std::hypot(q->from.x_m + t * q->velocity.x_m_s, q->from.y_m + t * q->velocity.y_m_s);
}

ChordOfPiece chord_of(const PlaneEdge& edge, const EdgePiece& piece) {
  const double length = edge.ground_length.value;
  const double dx = edge.to.x_m - edge.from.x_m;
  const double dy = edge.to.y_m - edge.from.y_m;
  const auto point = [&](double way_m) {
    return geo::PlanePoint{edge.from.x_m + way_m / length * dx, edge.from.y_m + way_m / length * dy};
  };
  const double h = piece.t1_s - piece.t0_s;
  const double gain = piece.way1_m - piece.way0_m;
  const double cubic = h * (piece.v0_m_s + piece.v1_m_s) - 2.0 * gain;
  const double square = 3.0 * gain - h * (2.0 * piece.v0_m_s + piece.v1_m_s);
  const double bend = std::max(std::abs(2.0 * square), std::abs(2.0 * square + 6.0 * cubic));
  return {{point(piece.way0_m), point(piece.way1_m), piece.t0_s, piece.t1_s},
          bend / 8.0 * std::hypot(dx, dy) / length};
}

HalvedPiece halve(const EdgePiece& piece) {
  const double h = piece.t1_s - piece.t0_s;
  const double t = piece.t0_s + 0.5 * h;
  const double way = 0.5 * (piece.way0_m + piece.way1_m) + h / 8.0 * (piece.v0_m_s - piece.v1_m_s);
  const double v =
      h > 0.0 ? 1.5 * (piece.way1_m - piece.way0_m) / h - 0.25 * (piece.v0_m_s + piece.v1_m_s) : piece.v0_m_s;
  return {{piece.t0_s, piece.way0_m, piece.v0_m_s, t, way, v},
          {t, way, v, piece.t1_s, piece.way1_m, piece.v1_m_s}};
}

}  // namespace floeplan::motion
