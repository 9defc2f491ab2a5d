#pragma once

#include <array>
#include <optional>

#include "storage/ingest/grids/source_mesh.hpp"
#include "storage/ingest/grids/tangent_plane.hpp"

namespace floeplan::ingest {

/// Weights of a cell's corners at places inside it: bilinear between four corners, linear between three, in the plane
/// that touches the Earth at the cell's centre. The weights sum to one.
class CellWeights {
 public:
  CellWeights(const SourceMesh& mesh, const SourceMesh::Cell& cell);
  /// Outside  nullopt beyond the cell; a hair's breadth outside counts as inside, so that no node falls between
  [[nodiscard]] std::optional<std::array<double, 4>> at(UnitVector place) const;

 private:
  [[nodiscard]] std::optional<std::array<double, 4>> in_triangle(TangentPlane::Point p) const;
  [[nodiscard]] std::optional<std::array<double, 4>> in_quadrilateral(TangentPlane::Point p) const;

  TangentPlane plane_;
  std::array<TangentPlane::Point, 4> corners_{};
  TangentPlane::Point least_{};
  TangentPlane::Point most_{};
  bool triangle_;
};

}  // namespace floeplan::ingest
