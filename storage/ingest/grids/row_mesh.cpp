#include "storage/ingest/grids/row_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geo/tangent_plane.hpp"

namespace floeplan::ingest {
namespace {

constexpr double longest_side_over_median = 20.0;
constexpr double most_gap_over_side =
    2.0;  // the first and the last column, or the halves of the top row, count as neighbours up to this many spacings

std::uint32_t index(std::size_t point) { return static_cast<std::uint32_t>(point); }

/// Joins the last column to the first if the grid goes around the globe without repeating a column.
void close_the_circle(ocean::Mesh& mesh, std::size_t columns, std::size_t rows) {
  const auto at = [&](std::size_t row, std::size_t column) { return row * columns + column; };
  const auto apart_m = [&](std::size_t a, std::size_t b) {
    return geo::sphere_distance_m(mesh.points[a], mesh.points[b]);
  };
  const auto meets = [&](std::size_t row) {
    const double gap_m = apart_m(at(row, columns - 1), at(row, 0));
    return gap_m > 0.0 && gap_m < most_gap_over_side * apart_m(at(row, 0), at(row, 1));
  };
  for (std::size_t row = 0; columns > 2 && row + 1 < rows; ++row)
    if (meets(row) && meets(row + 1))
      mesh.cells.push_back({index(at(row, columns - 1)), index(at(row, 0)), index(at(row + 1, 0)),
                            index(at(row + 1, columns - 1))});
}

/// Joins the two halves of the last row if the row is folded onto itself between the two northern poles of a
/// tripolar grid.
void close_the_fold(ocean::Mesh& mesh, std::size_t columns, std::size_t rows) {
  if (rows < 2 || columns < 4) return;
  const std::size_t top = (rows - 1) * columns;
  const auto apart_m = [&](std::size_t a, std::size_t b) {
    return geo::sphere_distance_m(mesh.points[a], mesh.points[b]);
  };
  for (std::size_t i = 0; i + 1 < columns / 2; ++i) {
    const std::size_t facing = columns - 1 - i;
    const bool meets =
        apart_m(top + i, top + facing) < most_gap_over_side * apart_m(top + i, top + i - columns) &&
        apart_m(top + i + 1, top + facing - 1) <
            most_gap_over_side * apart_m(top + i + 1, top + i + 1 - columns);
    if (meets)
      mesh.cells.push_back(
          {index(top + i), index(top + i + 1), index(top + facing - 1), index(top + facing)});
  }
}

}  // namespace

ocean::Mesh mesh_of_rows(std::vector<geo::LonLat> points, std::size_t columns) {
  ocean::Mesh mesh{std::move(points), {}};
  const std::size_t rows = mesh.points.size() / columns;
  for (std::size_t row = 0; row + 1 < rows; ++row)
    for (std::size_t column = 0; column + 1 < columns; ++column)
      mesh.cells.push_back({index(row * columns + column), index(row * columns + column + 1),
                            index((row + 1) * columns + column + 1), index((row + 1) * columns + column)});
  close_the_circle(mesh, columns, rows);
  close_the_fold(mesh, columns, rows);

  const double longest = longest_side_over_median * ocean::quantile_of_sides_m(mesh, 0.5);
  std::erase_if(mesh.cells, [&](const ocean::Mesh::Cell& cell) {
    const double side = ocean::longest_side_m(mesh, cell);
    return !(side > 0.0 && side <= longest);
  });
  return mesh;
}

ocean::Mesh mesh_of_components(const Positions& first, const Positions& second) {
  ocean::Mesh mesh = mesh_of_rows(first.places, first.columns);
  const ocean::Mesh beside = mesh_of_rows(second.places, second.columns);
  const std::uint32_t count = index(mesh.points.size());
  mesh.points.insert(mesh.points.end(), beside.points.begin(), beside.points.end());
  for (const ocean::Mesh::Cell& cell : beside.cells)
    mesh.cells.push_back({count + cell[1], count + cell[2], count + cell[3], count + cell[0]});
  return mesh;
}

}  // namespace floeplan::ingest
