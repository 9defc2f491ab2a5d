#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// The faces of a mesh, each with three or more corners in order around the face, given as indices of nodes.
class MeshFaces {
 public:
  using Corners = std::span<const std::uint32_t>;

  void add(Corners corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    ends_.push_back(corners_.size());
  }
  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] Corners operator[](std::size_t face) const {
    const std::size_t begin = face == 0 ? 0 : ends_[face - 1];
    return Corners{corners_}.subspan(begin, ends_[face] - begin);
  }

 private:
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> ends_;  // for each face the index after its last corner
};

/// A horizontal mesh as a file describes it.
struct MeshTopology {
  std::vector<geo::LonLat> nodes;
  MeshFaces faces;
  // positions for values in the faces, if the file states them; otherwise empty
  std::vector<geo::LonLat> middles;
  std::string node_dimension;
  std::string face_dimension;
};

/// Whether a variable lies on a mesh: on the nodes or faces of a UGRID topology, or on FVCOM's dimensions.
[[nodiscard]] bool lies_on_mesh(const NetcdfFile& file, const NetcdfVariable& variable);

/// The mesh of a file, by the UGRID conventions or as FVCOM writes it (nv, lon, lat).
/// Errors   no mesh; nodes without longitude and latitude; faces with corners that do not exist, or with more
///          than twelve; more nodes or faces than this program accepts
/// Source   UGRID conventions 1.0, section "2D triangular and flexible mesh topology"; FVCOM user manual
[[nodiscard]] Checked<MeshTopology> mesh_topology(const NetcdfFile& file);

}  // namespace floeplan::ingest
