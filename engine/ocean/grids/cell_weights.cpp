#include "engine/ocean/grids/cell_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace floeplan::ocean {
namespace {

constexpr double hair = 1e-6;       // tolerance, as a share of a cell
constexpr int max_iterations = 12;  // Newton's method doubles the number of digits each time

geo::UnitVector centre_of(const CellWeights::Corners& corners) {
  geo::UnitVector sum;
  for (const geo::UnitVector& corner : corners) sum = {sum.x + corner.x, sum.y + corner.y, sum.z + corner.z};
  const double length = std::sqrt(geo::dot(sum, sum));
  return {sum.x / length, sum.y / length, sum.z / length};
}

}  // namespace

CellWeights::CellWeights(const Corners& corners, bool is_triangle)
    : plane_{centre_of(corners)}, triangle_{is_triangle} {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  least_ = {infinite, infinite};
  most_ = {-infinite, -infinite};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners_[i] = plane_.project(corners[i]);
    least_ = {std::min(least_.x, corners_[i].x), std::min(least_.y, corners_[i].y)};
    most_ = {std::max(most_.x, corners_[i].x), std::max(most_.y, corners_[i].y)};
  }
  const double margin = hair * std::max(most_.x - least_.x, most_.y - least_.y);
  least_ = {least_.x - margin, least_.y - margin};
  most_ = {most_.x + margin, most_.y + margin};
}

std::optional<std::array<double, 4>> CellWeights::at(geo::UnitVector place) const {
  if (!plane_.faces(place)) return std::nullopt;
  const Point p = plane_.project(place);
  if (!(p.x >= least_.x && p.x <= most_.x && p.y >= least_.y && p.y <= most_.y)) return std::nullopt;
  return triangle_ ? in_triangle(p) : in_quadrilateral(p);
}

std::optional<std::array<double, 4>> CellWeights::in_triangle(Point p) const {
  const auto& [a, b, c, same] = corners_;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0.0) return std::nullopt;
  const double of_b = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area;
  const double of_c = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
  const double of_a = 1.0 - of_b - of_c;
  if (of_a < -hair || of_b < -hair || of_c < -hair) return std::nullopt;
  return std::array{of_a, of_b, of_c, 0.0};
}

/// Solves p = a + s (b - a) + t (d - a) + s t (a - b + c - d) for s and t.
std::optional<std::array<double, 4>> CellWeights::in_quadrilateral(Point p) const {
  const auto& [a, b, c, d] = corners_;
  const Point twist{a.x - b.x + c.x - d.x, a.y - b.y + c.y - d.y};
  double s = 0.5;
  double t = 0.5;
  for (int i = 0; i < max_iterations; ++i) {
    const double miss_x = a.x + s * (b.x - a.x) + t * (d.x - a.x) + s * t * twist.x - p.x;
    const double miss_y = a.y + s * (b.y - a.y) + t * (d.y - a.y) + s * t * twist.y - p.y;
    const double x_s = b.x - a.x + t * twist.x;
    const double y_s = b.y - a.y + t * twist.y;
    const double x_t = d.x - a.x + s * twist.x;
    const double y_t = d.y - a.y + s * twist.y;
    const double determinant = x_s * y_t - x_t * y_s;
    if (determinant == 0.0) return std::nullopt;
    const double step_s = (miss_x * y_t - x_t * miss_y) / determinant;
    const double step_t = (x_s * miss_y - miss_x * y_s) / determinant;
    s -= step_s;
    t -= step_t;
    if (std::abs(step_s) + std::abs(step_t) < 1e-12) break;
  }
  if (!(s >= -hair && s <= 1.0 + hair && t >= -hair && t <= 1.0 + hair)) return std::nullopt;
  return std::array{(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t};
}

}  // namespace floeplan::ocean
