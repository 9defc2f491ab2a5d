#pragma once

#include <array>
#include <optional>

#include "engine/geo/tangent_plane.hpp"

namespace floeplan::ocean {

/// Weights of a cell's corners at places inside: bilinear between four corners, linear (barycentric) between
/// three, in the plane that touches the Earth at the cell's centre. The weights add up to one.
class CellWeights {
 public:
  using Corners = std::array<geo::UnitVector, 4>;

  /// `corners`      in order around the cell
  /// `is_triangle`  the fourth corner repeats the third
  CellWeights(const Corners& corners, bool is_triangle);
  /// Outside  nullopt outside the cell. Places outside by only a rounding error count as inside, so that none
  ///          is lost
  [[nodiscard]] std::optional<std::array<double, 4>> at(geo::UnitVector place) const;

 private:
  using Point = geo::TangentPlane::Point;
  [[nodiscard]] std::optional<std::array<double, 4>> in_triangle(Point p) const;
  [[nodiscard]] std::optional<std::array<double, 4>> in_quadrilateral(Point p) const;

  geo::TangentPlane plane_;
  std::array<Point, 4> corners_{};
  Point least_{};
  Point most_{};
  bool triangle_;
};

}  // namespace floeplan::ocean
