#include "storage/ingest/grids/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/messages/ingest_grid_messages.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uint64_t max_nodes = 3'000'000;
constexpr std::uint64_t most_corners = 12;  // corners of a face. Chosen; Delft3D FM allows six

/// The variables that describe a mesh.
struct Description {
  const NetcdfVariable* lons{nullptr};
  const NetcdfVariable* lats{nullptr};
  const NetcdfVariable* faces{nullptr};
  bool by_ugrid{false};
  const NetcdfVariable* middle_lons{nullptr};  // null: the file has none
  const NetcdfVariable* middle_lats{nullptr};
};

/// The longitudes and the latitudes among several variables whose names are given, separated by blanks.
struct NamedCoordinates {
  const NetcdfVariable* lons{nullptr};
  const NetcdfVariable* lats{nullptr};
};

NamedCoordinates coordinates_named(const NetcdfFile& file, const std::string& text) {
  NamedCoordinates found;
  std::istringstream names{text};
  for (std::string name; names >> name;) {
    const NetcdfVariable* coordinate = file.find(name);
    if (coordinate == nullptr) continue;
    if (role_of(*coordinate) == AxisRole::longitude) found.lons = coordinate;
    if (role_of(*coordinate) == AxisRole::latitude) found.lats = coordinate;
  }
  return found;
}

const NetcdfVariable* topology_of(const NetcdfFile& file) {
  for (const NetcdfVariable& variable : file.variables())
    if (lower(variable.attribute("cf_role")) == "mesh_topology" &&
        variable.numeric_attribute("topology_dimension").value_or(2.0) == 2.0)
      return &variable;
  return nullptr;
}

Description describe_ugrid(const NetcdfFile& file, const NetcdfVariable& topology) {
  Description found;
  found.by_ugrid = true;
  found.faces = file.find(topology.attribute("face_node_connectivity"));
  const NamedCoordinates nodes = coordinates_named(file, topology.attribute("node_coordinates"));
  found.lons = nodes.lons;
  found.lats = nodes.lats;
  const NamedCoordinates middles = coordinates_named(file, topology.attribute("face_coordinates"));
  found.middle_lons = middles.lons;
  found.middle_lats = middles.lats;
  return found;
}

Description describe(const NetcdfFile& file) {
  if (const NetcdfVariable* topology = topology_of(file)) return describe_ugrid(file, *topology);
  return {file.find("lon"), file.find("lat"), file.find("nv"), false, file.find("lonc"), file.find("latc")};
}

bool is_whole(const Description& description) {
  return description.lons != nullptr && description.lats != nullptr && description.faces != nullptr &&
         description.lons->dimensions().size() == 1 && description.lats->dimensions().size() == 1 &&
         description.faces->dimensions().size() == 2 && description.faces->is_numeric() &&
         description.lons->dimensions()[0].name == description.lats->dimensions()[0].name;
}

/// The shape of the table with the corners of the faces; either dimension may come first.
struct FaceTable {
  std::size_t corner_dimension{};
  std::size_t corners{};
  std::size_t count{};
};

std::optional<FaceTable> table_of(const NetcdfVariable& faces) {
  const auto& dimensions = faces.dimensions();
  for (const std::size_t corner : {std::size_t{0}, std::size_t{1}}) {
    const std::uint64_t corners = dimensions[corner].size;
    const std::uint64_t count = dimensions[1 - corner].size;
    if ((corners == 3 || corners == 4) && count > 0 && (count > 4 || corner == 1))
      return FaceTable{corner, static_cast<std::size_t>(corners), static_cast<std::size_t>(count)};
  }
  // Delft3D FM has space for more corners than most faces have.
  const std::uint64_t corners = dimensions[1].size;
  if (corners > 4 && corners <= most_corners && dimensions[0].size > 0)
    return FaceTable{1, static_cast<std::size_t>(corners), static_cast<std::size_t>(dimensions[0].size)};
  return std::nullopt;
}

messages::Message damaged(const NetcdfVariable& faces) {
  return messages::ingest_grid_message<"mesh-damaged">(faces.name());
}

/// Removes entries for corners that a face does not have: invalid node numbers, or its own corners repeated.
void drop_repeats(std::vector<std::uint32_t>& corners) {
  while (corners.size() > 3 &&
         std::find(corners.begin(), corners.end() - 1, corners.back()) != corners.end() - 1)
    corners.pop_back();
}

Checked<MeshFaces> read_faces(const Description& description, std::size_t nodes) {
  const NetcdfVariable& table = *description.faces;
  if (table.dimensions()[0].size > 4 && table.dimensions()[1].size > most_corners &&
      table.dimensions()[0].size > most_corners)
    return refuse(messages::ingest_grid_message<"mesh-of-many-corners">(table.name(), most_corners));
  const auto shape = table_of(table);
  if (!shape || shape->count > 2 * max_nodes) return refuse(damaged(table));
  const auto values = table.read_all();
  if (!values) return refuse(values.error());

  // If no start_index is stated, UGRID counts from zero and FVCOM from one.
  const double start = table.numeric_attribute("start_index").value_or(description.by_ugrid ? 0.0 : 1.0);
  const auto at = [&](std::size_t face, std::size_t corner) {
    return (shape->corner_dimension == 0 ? (*values)[corner * shape->count + face]
                                         : (*values)[face * shape->corners + corner]) -
           start;
  };
  MeshFaces faces;
  std::vector<std::uint32_t> corners;
  for (std::size_t face = 0; face < shape->count; ++face) {
    corners.clear();
    for (std::size_t corner = 0; corner < shape->corners; ++corner) {
      const double node = at(face, corner);
      if (corner >= 3 && !(node >= 0.0)) break;
      if (!(node >= 0.0 && node < static_cast<double>(nodes)) || node != std::floor(node))
        return refuse(damaged(table));
      corners.push_back(static_cast<std::uint32_t>(node));
    }
    drop_repeats(corners);
    faces.add(corners);
  }
  return faces;
}

/// The positions of the faces; empty if the file has none, or not one for each face.
Checked<std::vector<geo::LonLat>> read_middles(const Description& description, std::size_t faces) {
  std::vector<geo::LonLat> middles;
  if (description.middle_lons == nullptr || description.middle_lats == nullptr) return middles;
  const auto fits = [&](const NetcdfVariable& variable) {
    return variable.dimensions().size() == 1 && variable.dimensions()[0].size == faces &&
           variable.is_numeric();
  };
  if (!fits(*description.middle_lons) || !fits(*description.middle_lats)) return middles;
  const auto lons = description.middle_lons->read_all();
  if (!lons) return refuse(lons.error());
  const auto lats = description.middle_lats->read_all();
  if (!lats) return refuse(lats.error());
  for (std::size_t i = 0; i < lons->size(); ++i) {
    if (!(std::abs((*lats)[i]) <= 90.0 && std::abs((*lons)[i]) <= 720.0)) return std::vector<geo::LonLat>{};
    middles.push_back({geo::wrap_longitude((*lons)[i]), (*lats)[i]});
  }
  return middles;
}

}  // namespace

bool lies_on_mesh(const NetcdfFile& file, const NetcdfVariable& variable) {
  const Description description = describe(file);
  if (!is_whole(description)) return false;
  const auto shape = table_of(*description.faces);
  if (!shape) return false;
  const std::string& nodes = description.lons->dimensions()[0].name;
  const std::string& faces = description.faces->dimensions()[1 - shape->corner_dimension].name;
  return std::ranges::any_of(variable.dimensions(), [&](const NetcdfDimension& dimension) {
    return dimension.name == nodes || dimension.name == faces;
  });
}

Checked<MeshTopology> mesh_topology(const NetcdfFile& file) {
  const Description description = describe(file);
  if (!is_whole(description)) return refuse(messages::ingest_grid_message<"mesh-not-described">());
  const std::uint64_t count = description.lons->dimensions()[0].size;
  if (count == 0 || count > max_nodes)
    return refuse(messages::ingest_grid_message<"mesh-too-large">(count, max_nodes));
  const auto lons = description.lons->read_all();
  if (!lons) return refuse(lons.error());
  const auto lats = description.lats->read_all();
  if (!lats) return refuse(lats.error());
  auto faces = read_faces(description, lons->size());
  if (!faces) return refuse(faces.error());

  MeshTopology mesh;
  for (std::size_t i = 0; i < lons->size(); ++i) {
    const double lon = (*lons)[i];
    const double lat = (*lats)[i];
    if (!(std::abs(lat) <= 90.0 && std::abs(lon) <= 720.0))
      return refuse(messages::ingest_grid_message<"mesh-node-off-the-earth">(number(lon), number(lat)));
    mesh.nodes.push_back({geo::wrap_longitude(lon), lat});
  }
  auto middles = read_middles(description, faces->size());
  if (!middles) return refuse(middles.error());
  mesh.middles = std::move(*middles);
  mesh.faces = std::move(*faces);
  mesh.node_dimension = description.lons->dimensions()[0].name;
  mesh.face_dimension =
      description.faces->dimensions()[1 - table_of(*description.faces)->corner_dimension].name;
  return mesh;
}

}  // namespace floeplan::ingest
