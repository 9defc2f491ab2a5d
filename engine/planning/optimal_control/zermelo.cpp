#include "engine/planning/optimal_control/zermelo.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace floeplan::planning::optimal_control {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr int most_newton_steps = 100;
constexpr double converged = 1e-11;
constexpr double least_damping = 1e-5;
/// Step of central differences, as a share of an unknown's scale: the cube root of the rounding error.
constexpr double newton_difference = 6e-6;

/// The boundary value problem with dimensionless unknowns. Unit of lengths: the distance from start to goal.
/// Unit of times: the duration of the guess. Order of the unknowns: heading at the start, each inner point,
/// duration.
class Shooting {
 public:
  Shooting(const Crossing& crossing, const ExtremalFlow& flow, const ExtremalGuess& guess)
      : crossing_{crossing},
        flow_{flow},
        pieces_{static_cast<Eigen::Index>(guess.points.size()) - 1},
        length_m_{geo::distance_m(crossing.from, crossing.to)},
        time_s_{guess.duration.count()} {}

  [[nodiscard]] Vector pack(const ExtremalGuess& guess) const {
    Vector z(3 * pieces_ - 1);
    z[0] = guess.points.front().heading;
    for (Eigen::Index i = 1; i < pieces_; ++i) z.segment<3>(3 * i - 2) = scaled(guess.points[index(i)]);
    z[3 * pieces_ - 2] = guess.duration.count() / time_s_;
    return z;
  }

  [[nodiscard]] core::Seconds duration(const Vector& z) const {
    return core::Seconds{z[3 * pieces_ - 2] * time_s_};
  }

  /// The place and the heading at the start of a piece.
  [[nodiscard]] SteeredPoint point(const Vector& z, Eigen::Index piece) const {
    if (piece == 0) return {crossing_.from.x_m, crossing_.from.y_m, z[0]};
    const Eigen::Vector3d at = z.segment<3>(3 * piece - 2);
    return {at[0] * length_m_, at[1] * length_m_, at[2]};
  }

  /// The gaps between the pieces of the route; empty if the current is unknown somewhere.
  [[nodiscard]] std::optional<Vector> gaps(const Vector& z) const {
    Vector result(3 * pieces_ - 1);
    for (Eigen::Index i = 0; i < pieces_; ++i) {
      const auto end = end_of_piece(point(z, i), i, duration(z));
      if (!end) return std::nullopt;
      if (i + 1 < pieces_) {
        result.segment<3>(3 * i) = *end - scaled(point(z, i + 1));
      } else {
        result[3 * i] = (*end)[0] - crossing_.to.x_m / length_m_;
        result[3 * i + 1] = (*end)[1] - crossing_.to.y_m / length_m_;
      }
    }
    return result;
  }

  /// Derivatives of the gaps with respect to the unknowns, by central differences.
  [[nodiscard]] std::optional<Matrix> slopes(const Vector& z) const {
    Matrix result = Matrix::Zero(z.size(), z.size());
    for (Eigen::Index i = 0; i < pieces_; ++i) {
      const Eigen::Index rows = i + 1 < pieces_ ? 3 : 2;
      const auto put = [&](Eigen::Index column, const std::optional<Eigen::Vector3d>& slope) {
        if (slope) result.block(3 * i, column, rows, 1) = slope->head(rows);
        return slope.has_value();
      };
      for (int part = i == 0 ? 2 : 0; part < 3; ++part) {
        if (!put(i == 0 ? 0 : 3 * i - 2 + part, slope_by_start(z, i, part))) return std::nullopt;
      }
      if (!put(z.size() - 1, slope_by_duration(z, i))) return std::nullopt;
      if (rows == 3) result.block<3, 3>(3 * i, 3 * i + 1) -= Eigen::Matrix3d::Identity();
    }
    return result;
  }

 private:
  static std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Eigen::Vector3d scaled(const SteeredPoint& at) const {
    return {at.x_m / length_m_, at.y_m / length_m_, at.heading};
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> end_of_piece(const SteeredPoint& start, Eigen::Index piece,
                                                            core::Seconds duration) const {
    const core::Seconds piece_duration = duration / static_cast<double>(pieces_);
    const auto end =
        flow_(start, crossing_.depart + static_cast<double>(piece) * piece_duration, piece_duration);
    if (!end) return std::nullopt;
    return scaled(*end);
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> slope_by_start(const Vector& z, Eigen::Index piece,
                                                              int part) const {
    const auto end = [&](double by) {
      SteeredPoint start = point(z, piece);
      if (part == 0) start.x_m += by * length_m_;
      if (part == 1) start.y_m += by * length_m_;
      if (part == 2) start.heading += by;
      return end_of_piece(start, piece, duration(z));
    };
    return difference(end(-newton_difference), end(newton_difference));
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> slope_by_duration(const Vector& z, Eigen::Index piece) const {
    const auto end = [&](double by) {
      return end_of_piece(point(z, piece), piece, duration(z) + core::Seconds{by * time_s_});
    };
    return difference(end(-newton_difference), end(newton_difference));
  }

  static std::optional<Eigen::Vector3d> difference(const std::optional<Eigen::Vector3d>& before,
                                                   const std::optional<Eigen::Vector3d>& after) {
    if (!before || !after) return std::nullopt;
    return (*after - *before) / (2.0 * newton_difference);
  }

  const Crossing& crossing_;
  const ExtremalFlow& flow_;
  Eigen::Index pieces_;
  double length_m_;
  double time_s_;
};

/// The unknowns for which all gaps are zero.
tl::expected<Vector, NoExtremal> solve(const Shooting& shooting, Vector z, const std::stop_token& stop) {
  auto gaps = shooting.gaps(z);
  if (!gaps) return tl::unexpected(NoExtremal::outside_data);

  double damping = 1.0;
  for (int i = 0; i < most_newton_steps; ++i) {
    if (stop.stop_requested()) return tl::unexpected(NoExtremal::cancelled);
    const auto slopes = shooting.slopes(z);
    if (!slopes) return tl::unexpected(NoExtremal::outside_data);
    const Eigen::PartialPivLU<Matrix> solver{*slopes};
    const Vector step = -solver.solve(*gaps);
    const double distance = step.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(distance)) return tl::unexpected(NoExtremal::not_converged);
    if (distance < converged) return z;

    // Each step must come nearer to the solution. Measure: the length of the next step, if the derivatives
    // stayed the same.
    damping = std::min(1.0, 4.0 * damping);
    for (;; damping *= 0.5) {
      if (damping < least_damping) return tl::unexpected(NoExtremal::not_converged);
      const Vector trial = z + damping * step;
      if (!(shooting.duration(trial).count() > 0.0)) continue;
      const auto gaps_there = shooting.gaps(trial);
      if (!gaps_there) continue;
      const double distance_there = solver.solve(*gaps_there).norm();
      // Near the solution rounding errors end the descent.
      const bool at_rounding = damping == 1.0 && distance_there < converged;
      if (!at_rounding && !(distance_there <= (1.0 - 0.25 * damping) * step.norm())) continue;
      z = trial;
      gaps = gaps_there;
      break;
    }
  }
  return tl::unexpected(NoExtremal::not_converged);
}

}  // namespace

std::optional<ExtremalGuess> guess_along(
    const TimedWay& route,
    const std::function<std::optional<motion::CurrentXy>(geo::PlanePoint, core::Seconds)>& current,
    std::size_t pieces) {
  if (route.points.size() < 2 || pieces < 2) {
    throw std::invalid_argument{"a guess needs a route of two points and two pieces"};
  }
  ExtremalGuess guess{.duration = route.duration(), .points = {}};
  const core::Seconds step = guess.duration / static_cast<double>(pieces);
  for (std::size_t i = 0; i <= pieces; ++i) {
    const core::Seconds time = route.times.front() + static_cast<double>(i) * step;
    const geo::PlanePoint at = route.at(time);
    const auto c = current(at, time);
    if (!c) return std::nullopt;
    // The average course between the steps before and after smooths the corners of the route.
    const core::Seconds from = std::max(time - step, route.times.front());
    const core::Seconds to = std::min(time + step, route.times.back());
    const geo::PlanePoint a = route.at(from);
    const geo::PlanePoint b = route.at(to);
    const double seconds = (to - from).count();
    double heading = std::atan2((b.y_m - a.y_m) / seconds - c->y_m_s, (b.x_m - a.x_m) / seconds - c->x_m_s);
    if (i > 0) {
      const double turn = heading - guess.points.back().heading;
      heading -= 2.0 * std::numbers::pi * std::round(turn / (2.0 * std::numbers::pi));
    }
    guess.points.push_back({at.x_m, at.y_m, heading});
  }
  return guess;
}

tl::expected<Extremal, NoExtremal> solve_extremal(const Crossing& crossing, const ExtremalFlow& flow,
                                                  const ExtremalGuess& guess, const std::stop_token& stop) {
  if (guess.points.size() < 3 || !(guess.duration.count() > 0.0) || crossing.from == crossing.to) {
    throw std::invalid_argument{"an extremal needs two places and a guess of two pieces or more"};
  }
  const Shooting shooting{crossing, flow, guess};
  const auto z = solve(shooting, shooting.pack(guess), stop);
  if (!z) return tl::unexpected(z.error());

  Extremal extremal{.duration = shooting.duration(*z), .points = {}};
  const auto pieces = static_cast<Eigen::Index>(guess.points.size()) - 1;
  for (Eigen::Index i = 0; i < pieces; ++i) extremal.points.push_back(shooting.point(*z, i));
  const core::Seconds piece = extremal.duration / static_cast<double>(pieces);
  const auto end =
      flow(extremal.points.back(), crossing.depart + static_cast<double>(pieces - 1) * piece, piece);
  if (!end) return tl::unexpected(NoExtremal::outside_data);
  extremal.points.push_back({crossing.to.x_m, crossing.to.y_m, end->heading});
  return extremal;
}

}  // namespace floeplan::planning::optimal_control
