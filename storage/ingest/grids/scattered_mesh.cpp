#include "storage/ingest/grids/scattered_mesh.hpp"

#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "storage/ingest/common/gdal_guard.hpp"

namespace floeplan::ingest {
namespace {

/// Chosen: on a square grid the median side is the cell's side or its diagonal. A diagonal is 1.41 sides
/// long, two sides are 1.41 diagonals; a side across one missing node has to be longer than this limit.
constexpr double longest_over_median = 1.35;

double longest_side_of(const ocean::Mesh& mesh, const ocean::Mesh::Cell& cell) {
  double longest_m = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    longest_m =
        std::max(longest_m, geo::sphere_distance_m(mesh.points[cell[i]], mesh.points[cell[(i + 1) % 3]]));
  return longest_m;
}

void leave_out_long_cells(ocean::Mesh& mesh) {
  std::vector<double> sides_m;
  for (const ocean::Mesh::Cell& cell : mesh.cells) sides_m.push_back(longest_side_of(mesh, cell));
  const auto middle = sides_m.begin() + static_cast<std::ptrdiff_t>(sides_m.size() / 2);
  std::nth_element(sides_m.begin(), middle, sides_m.end());
  const double most_m = longest_over_median * *middle;
  std::erase_if(mesh.cells,
                [&](const ocean::Mesh::Cell& cell) { return longest_side_of(mesh, cell) > most_m; });
}

}  // namespace

std::optional<ocean::Mesh> mesh_of_places(std::vector<geo::LonLat> places) {
  if (places.size() < 3) return std::nullopt;
  geo::UnitVector sum;
  for (const geo::LonLat place : places) {
    const geo::UnitVector each = geo::unit_vector(place);
    sum = {sum.x + each.x, sum.y + each.y, sum.z + each.z};
  }
  const double length = std::sqrt(geo::dot(sum, sum));
  if (!(length > 0.0)) return std::nullopt;
  const geo::TangentPlane plane{{sum.x / length, sum.y / length, sum.z / length}};
  std::vector<double> xs;
  std::vector<double> ys;
  for (const geo::LonLat place : places) {
    const geo::UnitVector each = geo::unit_vector(place);
    if (!plane.faces(each)) return std::nullopt;
    const geo::TangentPlane::Point point = plane.project(each);
    xs.push_back(point.x);
    ys.push_back(point.y);
  }
  const GdalMessages quiet;
  const std::unique_ptr<GDALTriangulation, void (*)(GDALTriangulation*)> triangles{
      GDALTriangulationCreateDelaunay(static_cast<int>(places.size()), xs.data(), ys.data()),
      GDALTriangulationFree};
  if (!triangles || triangles->nFacets == 0) return std::nullopt;
  ocean::Mesh mesh{std::move(places), {}};
  for (int i = 0; i < triangles->nFacets; ++i) {
    const int* const corners = triangles->pasFacets[i].anVertexIdx;
    const auto third = static_cast<std::uint32_t>(corners[2]);
    mesh.cells.push_back(
        {static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]), third, third});
  }
  leave_out_long_cells(mesh);
  return mesh;
}

Checked<S100Mesh> mesh_of(const S100Points& points) {
  if (points.triangles.empty()) {
    auto mesh = mesh_of_places(points.places);
    if (!mesh) return refuse(messages::ingest_hdf5_message<"s-places-without-area">());
    return S100Mesh{std::move(*mesh), "places of their own"};
  }
  S100Mesh triangulated{{points.places, {}}, "a triangulated mesh"};
  for (const auto& [first, second, third] : points.triangles)
    triangulated.mesh.cells.push_back({first, second, third, third});
  return triangulated;
}

}  // namespace floeplan::ingest
