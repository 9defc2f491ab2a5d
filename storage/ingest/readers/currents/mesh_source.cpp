#include <algorithm>
#include <cmath>
#include <span>

#include "engine/geo/tangent_plane.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/common/missing_value.hpp"
#include "storage/ingest/grids/bed_levels.hpp"
#include "storage/ingest/grids/mesh_levels.hpp"
#include "storage/ingest/grids/mesh_topology.hpp"
#include "storage/ingest/grids/netcdf_shape.hpp"
#include "storage/ingest/readers/currents/velocity_sources.hpp"
#include "storage/ingest/readers/velocity/component_checks.hpp"
#include "storage/ingest/readers/velocity/velocity_component.hpp"

namespace floeplan::ingest {
namespace {

struct MeshParts {
  NetcdfFiles files;  // references that keep the files open
  VelocityComponent first;
  VelocityComponent second;
  bool in_faces{false};
  MeshFaces faces;
  std::vector<geo::LonLat> points;  // the nodes, then the middles of faces with currents
  std::size_t nodes{};
  std::shared_ptr<const BedLevels> levels;  // null: levels are depths, or there are none
  // true: depths of levels are known in the faces; false: at the nodes
  bool levels_in_faces{false};
};

class MeshSource : public VelocitySource {
 public:
  explicit MeshSource(MeshParts parts) : parts_{std::move(parts)} {
    shape_ = shape_in_time_and_depth(parts_.first.layout(), parts_.levels != nullptr);
    shape_.columns = parts_.points.size();
  }

  [[nodiscard]] const SourceShape& shape() const override { return shape_; }
  [[nodiscard]] geo::LonLat place(std::size_t point) const override { return parts_.points[point]; }

  [[nodiscard]] Checked<VelocitySlice> read(std::size_t time, std::size_t level) const override {
    const std::size_t file_level = parts_.levels ? parts_.levels->file_level(level) : level;
    const auto east = parts_.first.read(time, file_level);
    if (!east) return refuse(east.error());
    const auto north = parts_.second.read(time, file_level);
    if (!north) return refuse(north.error());
    VelocitySlice slice{std::vector<float>(shape_.points(), missing),
                        std::vector<float>(shape_.points(), missing),
                        std::max(east->undeclared_fill, north->undeclared_fill)};
    slice.flagged = of_both(east->flagged, north->flagged);
    const std::size_t first = parts_.in_faces ? parts_.nodes : 0;
    for (std::size_t i = 0; i < east->values.size(); ++i) {
      if (std::isnan(east->values[i]) || std::isnan(north->values[i])) continue;
      slice.east[first + i] = static_cast<float>(east->values[i]);
      slice.north[first + i] = static_cast<float>(north->values[i]);
    }
    return slice;
  }

  [[nodiscard]] Checked<std::vector<float>> level_depths(std::size_t time, std::size_t level) const override {
    auto depths = parts_.levels->depths(time, level);
    if (!depths) return depths;
    if (parts_.levels_in_faces) {
      std::vector<float> at_points = means_at_nodes(*depths);
      if (parts_.in_faces) at_points.insert(at_points.end(), depths->begin(), depths->end());
      return at_points;
    }
    if (!parts_.in_faces) return depths;
    for (std::size_t face = 0; face < parts_.faces.size(); ++face) {
      const MeshFaces::Corners corners = parts_.faces[face];
      float sum = 0.0F;
      for (const std::uint32_t corner : corners) sum += (*depths)[corner];
      depths->push_back(sum / static_cast<float>(corners.size()));
    }
    return depths;
  }

 private:
  /// At each node the mean of the values in the faces around it that are not missing.
  [[nodiscard]] std::vector<float> means_at_nodes(std::span<const float> in_faces) const {
    std::vector<double> sums(parts_.nodes, 0.0);
    std::vector<int> count(parts_.nodes, 0);
    for (std::size_t i = 0; i < parts_.faces.size(); ++i) {
      if (std::isnan(in_faces[i])) continue;
      for (const std::uint32_t corner : parts_.faces[i]) {
        sums[corner] += static_cast<double>(in_faces[i]);
        ++count[corner];
      }
    }
    std::vector<float> means(parts_.nodes, missing);
    for (std::size_t node = 0; node < parts_.nodes; ++node)
      if (count[node] > 0) means[node] = static_cast<float>(sums[node] / count[node]);
    return means;
  }

  MeshParts parts_;
  SourceShape shape_;
};

/// Whether all sides of a face run the same way around a place. Triangles from the place to the sides then
/// fill the face.
bool sees_all_sides(geo::LonLat place, const MeshTopology& mesh, MeshFaces::Corners face) {
  const geo::UnitVector middle = geo::unit_vector(place);
  const auto from_middle = [&](std::uint32_t node) {
    const geo::UnitVector u = geo::unit_vector(mesh.nodes[node]);
    return geo::UnitVector{u.x - middle.x, u.y - middle.y, u.z - middle.z};
  };
  bool any_left = false;
  bool any_right = false;
  for (std::size_t corner = 0; corner < face.size(); ++corner) {
    const geo::UnitVector a = from_middle(face[corner]);
    const geo::UnitVector b = from_middle(face[(corner + 1) % face.size()]);
    const geo::UnitVector across{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const double hand = geo::dot(across, middle);
    any_left = any_left || hand >= 0.0;
    any_right = any_right || hand <= 0.0;
  }
  return any_left != any_right;
}

/// The position of a face's value: the file's, if it is inside the face; otherwise the mean of its corners.
geo::LonLat middle_of(const MeshTopology& mesh, std::size_t number) {
  const MeshFaces::Corners face = mesh.faces[number];
  if (!mesh.middles.empty() && sees_all_sides(mesh.middles[number], mesh, face)) return mesh.middles[number];
  geo::UnitVector sum;
  for (const std::uint32_t node : face) {
    const geo::UnitVector corner = geo::unit_vector(mesh.nodes[node]);
    sum = {sum.x + corner.x, sum.y + corner.y, sum.z + corner.z};
  }
  return geo::lon_lat(sum);
}

/// The faces as cells of three or four corners. A larger face is divided into triangles that share its first
/// corner.
std::vector<ocean::Mesh::Cell> cells_of(const MeshFaces& faces) {
  std::vector<ocean::Mesh::Cell> cells;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const MeshFaces::Corners face = faces[i];
    if (face.size() == 4) {
      cells.push_back({face[0], face[1], face[2], face[3]});
      continue;
    }
    for (std::size_t corner = 2; corner < face.size(); ++corner)
      cells.push_back({face[0], face[corner - 1], face[corner], face[corner]});
  }
  return cells;
}

/// Divides each face into triangles between its middle and its sides.
std::vector<ocean::Mesh::Cell> split_faces(const MeshTopology& mesh) {
  std::vector<ocean::Mesh::Cell> cells;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const MeshFaces::Corners face = mesh.faces[i];
    const auto middle = static_cast<std::uint32_t>(mesh.nodes.size() + i);
    for (std::size_t corner = 0; corner < face.size(); ++corner) {
      const std::uint32_t next = face[(corner + 1) % face.size()];
      cells.push_back({middle, face[corner], next, next});
    }
  }
  return cells;
}

}  // namespace

Checked<MeshCurrents> mesh_currents(const NetcdfFiles& files, const VelocityPair& pair, Messages& warnings) {
  if (pair.axes == VelocityAxes::grid)
    return refuse(
        messages::ingest_current_message<"mesh-has-no-axes">(pair.first->name(), pair.second->name()));
  auto mesh = mesh_topology(*pair.first_file);
  if (!mesh) return refuse(mesh.error());
  const auto along_faces = pair.first->dimension_named(mesh->face_dimension);
  const auto along = along_faces ? along_faces : pair.first->dimension_named(mesh->node_dimension);
  const auto second_along =
      pair.second->dimension_named(along_faces ? mesh->face_dimension : mesh->node_dimension);
  if (!along || !second_along)
    return refuse(
        messages::ingest_current_message<"mesh-components-apart">(pair.first->name(), pair.second->name()));
  auto layout = layout_over(*pair.first_file, *pair.first, *along, *along);
  if (!layout) return refuse(layout.error());
  auto second_layout = layout_over(*pair.second_file, *pair.second, *second_along, *second_along);
  if (!second_layout) return refuse(second_layout.error());
  if (const auto differs = times_or_depths_differ(*layout, *second_layout)) return refuse(*differs);

  MeshLevels levels;
  if (layout->bed_levels > 0) {
    const auto file = std::ranges::find_if(
        files, [&](const auto& candidate) { return candidate.get() == pair.first_file; });
    auto found = mesh_levels(*file, *pair.first, *layout, *mesh, warnings);
    if (!found) return refuse(found.error());
    levels = std::move(*found);
  }
  warnings.insert(warnings.end(), layout->warnings.begin(), layout->warnings.end());
  auto u = VelocityComponent::of(*pair.first_file, *pair.first, std::move(*layout), warnings);
  if (!u) return refuse(u.error());
  auto v = VelocityComponent::of(*pair.second_file, *pair.second, std::move(*second_layout), warnings);
  if (!v) return refuse(v.error());

  ocean::Mesh cells{mesh->nodes, along_faces ? split_faces(*mesh) : cells_of(mesh->faces),
                    along_faces.has_value()};
  if (along_faces)
    for (std::size_t face = 0; face < mesh->faces.size(); ++face)
      cells.points.push_back(middle_of(*mesh, face));
  auto source = std::make_shared<const MeshSource>(MeshParts{.files = files,
                                                             .first = std::move(*u),
                                                             .second = std::move(*v),
                                                             .in_faces = along_faces.has_value(),
                                                             .faces = std::move(mesh->faces),
                                                             .points = cells.points,
                                                             .nodes = mesh->nodes.size(),
                                                             .levels = std::move(levels.levels),
                                                             .levels_in_faces = levels.in_faces});
  return MeshCurrents{std::move(source), std::move(cells),
                      along_faces ? "the faces of a mesh" : "the nodes of a mesh"};
}

}  // namespace floeplan::ingest
